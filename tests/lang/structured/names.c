//@ structured
// Names that hide each other, and statics that would take the name of another function's local.
// expect: v=3, w=11, x=7
int v, w, x;
void t0() {
  int v = 1, t1_count = 2;
  {
    int v = 10;
    w = v + 1;
  }
  x = v + t1_count * 3;
}
void t1() {
  static int count = 2;
  count++;
  v = count;
}
