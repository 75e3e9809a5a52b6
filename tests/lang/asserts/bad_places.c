//@ assert: outside == 0    // expect error MP141
int x;
int t0() {
  x = 1;
  // expect error MP141 @6
  //@ assert:
  x = 2;
  //@ assert x == 1: x < 3    // expect error MP141
  x = 3;
  //@ assert: last == 0     // expect error MP141
}
//@ assert: between == 0    // expect error MP141
int t1() {
  //@ assert: x < 3
  return x;
}
