TTrapPrm trap;
int v;
double acc;
int t0() {
  TJogPrm jog;
  TPid pid;
  trap.acc = 0.25;
  trap.smoothTime = 25;
  v = trap.smoothTime + 1;
  acc = trap.acc;
  jog.smooth = 0.5;
  pid.integralLimit = 3;
  pid.kp = 1;
  return 0; // expect: v=26, acc=0.25
}
