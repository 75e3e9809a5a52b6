int outer() {
  return 0;
int t1() { // expect error MP012
  return 0;
}
