TTrapPrm trap;
TTrapPrm many[3]; // expect error MP016
int v;
int t0() {
  trap.accel = 1; // expect error MP029
  v.x = 1; // expect error MP029
  v = trap; // expect error MP031
  trap = v; // expect error MP031
  trap->acc = 0.5; // expect error MP028
  v = trap.acc; // expect error MP019
  return 0;
}
