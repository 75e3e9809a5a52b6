TPid pid;
int v;
int t0() {
  pid.limit = 1;
  if (pid.limit) goto yes;
  v = 1;
yes:
  v = v + 2;
  return 0; // expect: v=2
}
