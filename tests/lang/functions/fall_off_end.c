int v; // expect: v=1
void t0() {
  v = 1;
}
