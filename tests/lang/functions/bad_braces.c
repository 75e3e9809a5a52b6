int t0() {
  return 0;
}
} // expect error MP024
int t1() return 0; } // expect error MP040
int t2(int a); // expect error MP040
