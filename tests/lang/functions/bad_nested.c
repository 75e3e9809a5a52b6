int outer() {
  int inner() { // expect error MP012
    return 0;
  }
  return 0;
}
