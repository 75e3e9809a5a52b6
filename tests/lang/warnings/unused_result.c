int sum;
int t0(int n) {
  int area, sts, clock;
  TJogPrm jog;
  area = n * n; // expect warning MP137
  area = n + 1;
  GT_GetSts(1, &sts, 1, &clock);
  jog.smooth = 0;
  n = 3;
  return sum;
}
