//@ structured
int x;
static int never_called() {
  //@ assert: x == 0       // expect error MP141
  return x;
}
int t0() {
  if (0) {
    //@ assert: x == 0     // expect error MP141
    x = 1;
  }
  return x;
}
