//@ structured
//@ assert: outside == 0   // expect error MP141
int x, a[2][3];
int t0(int p) {
  while (p < 3) {
    ++p;
    //@ assert: p < 3      // expect error MP141
  }
  // expect error MP141 @10
  //@ assert:
  x = a[p][0];
  //@ assert: a[1] == 0    // expect error MP141
  a[0][0] = 1;
  //@ assert: a[2][0] == 0 // expect error MP141
  a[0][1] = 1;
  return x;
}
