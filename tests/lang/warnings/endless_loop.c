int count;
int t0() {
loop:
  count = count + 1; // expect warning MP134
  goto loop;
}
int t1() {
  int busy;
  busy = 1;
here:
  if (busy) goto here;
  return 0;
}
int t2() {
scan:
  GT_Delay(1);
  count = 0;
  goto scan;
}
int t3() {
self:
  goto self; // expect warning MP134
}
