// expect ok
int sum;
int t0(int first) {
  int i, a[4], clock, sts, set;
  TTrapPrm trap;
  GT_GetSts(1, &sts, 1, &clock);
  GT_GetTrapPrm(1, &trap);
  set = sts & clock;
  if (set) goto known;
  i = 3;
  a[i] = 4;
known:
  sum = sum + i;
  sum = sum + a[1];
  sum = sum + trap.smoothTime;
  return sum;
}
