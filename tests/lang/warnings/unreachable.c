int state;
int t0() {
  state = 1;
  goto done;
  state = 2; // expect warning MP136
  state = 3;
done:
  return 0;
}
int t1() {
loop:
  GT_Delay(1);
  goto loop;
  return 0;
}
