//@ structured
int f(a, b) // expect error MP207
int a; int b;
{
  return a;
}
int f2(a, b) { // expect error MP207 // expect error MP207
  return a;
}
int g(int) { // expect error MP128
  return 0;
}
void t0() {
  int h(int x) { // expect error MP012
    return x;
  }
}
