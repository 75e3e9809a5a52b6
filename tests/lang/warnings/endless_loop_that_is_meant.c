//@ endless
int count;
int t0() {
loop:
  count = count + 1;
  goto loop;
}
