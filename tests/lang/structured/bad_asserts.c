//@ structured
int x;
void t0() {
  //@ assert: x < 3         // expect error MP141
  x = x * 2 + 1;
}
