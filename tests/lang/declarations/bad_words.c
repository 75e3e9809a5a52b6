int 5; // expect error MP128
int if; // expect error MP128
int t0() {
  int a, ; // expect error MP128
  return 0;
}
