int f() {
  return 0;
}
TTrapPrm g() { // expect error MP005
  return;
}
int *h() { // expect error MP005
  return 0;
}
