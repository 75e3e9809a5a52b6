int sum;
int t0() {
  int i, cc;
  i = 1;
again:
again_too:
  sum = sum + i;
  i = i + 1;
  cc = i <= 10;
  if (cc) goto again;
  cc = i == 11;
  if (cc) goto again_done;
  goto again_too;
again_done: return sum; // expect: sum=55
}
