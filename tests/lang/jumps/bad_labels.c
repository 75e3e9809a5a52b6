int t0() {
  int cc;
one:
  cc = 1;
one: // expect error MP013
  cc = 2;
  goto two; // expect error MP020
  goto two;
last: // expect error MP025
}
int t1() {
  goto one; // expect error MP020
  return 0;
last: // expect error MP025
  ;
}
int t2() {
early: // expect error MP011
  int x;
  goto early;
}
