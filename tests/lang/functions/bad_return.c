void f() {
  return 1; // expect error MP123
}
int g() {
  return 1.5; // expect error MP019
}
double h() {
  int i;
  return i; // expect error MP019
}
int k() {
  int i;
  return i + 1; // expect error MP100
}
