//@ structured
// expect ok
int x;
#if 0
int before() {
  //@ assert: x == 0
  return x;
}
#endif
int t0() {
  //@ assert: x < 3
  x = 1;
  return x;
}
