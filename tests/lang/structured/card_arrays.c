//@ structured
// Arrays of the card's structures, and of structures that have them: an array for each member.
struct axis {
  int number;
  TTrapPrm trap;
  struct {
    TPid pid[2];
    short used;
  } servo;
};
struct axis axis[3] = {{1, {2, 3, 0.5, 4}}, {.number = 2, .trap = {7, 6}, .servo = {.used = 1}}, {3, 9, 8}};
TTrapPrm traps[4] = {{1, 2, 3, 4}, 5, 6, 7, 8, [3].smoothTime = 9}, single = {10, 11, 12, 13};
TJogPrm jogs[2][2];
const TTrapPrm presets[2] = {{0.25, 0.5}, {1.5, 2.5, 0.5, 20}};
struct axis one;
int set, got, refused, stepped, narrow, copied, calls, order, moved, local_sum, passed, made, sizes, pid, jog;
int kept, taken, filled, last, preset, i;
double real, sum;
static int next(void) { return calls++; }
static double total(TTrapPrm t) { return t.acc + t.dec * 10 + t.velStart * 100 + t.smoothTime * 1000; }
static double all(TTrapPrm *list, int count) {
  double s = 0;
  while (count-- > 0) s = s * 2 + total(*list++);
  return s;
}
static void faster(TTrapPrm *t, double by) {
  t->acc *= by;
  t->smoothTime++;
}
static void apply(struct axis *a) {
  GT_PrfTrap(a->number);
  GT_SetTrapPrm(a->number, &a->trap);
}
static TTrapPrm best(const TTrapPrm *list) { return list[0].acc > list[1].acc ? list[0] : list[1]; }
static struct axis renumbered(struct axis a, int number) {
  a.number = number;
  return a;
}
static void set_all(TTrapPrm list[], int count) {
  for (int n = 0; n < count; n++) GT_SetTrapPrm(n + 1, list + n);
}
void t0(int start) {
  TTrapPrm list[2] = {{1, 2}, traps[1]}, t = axis[0].trap;
  struct axis local[2] = {axis[0], {.trap = single, .number = 5}};
  i = start + 1;
  for (int n = 0; n < 3; n++) apply(&axis[n]);
  GT_SetTrapPrm(axis[i].number, &axis[i].trap);
  GT_GetTrapPrm(1, &axis[i].trap);
  set = axis[1].trap.smoothTime * 100 + axis[1].trap.acc * 10 + axis[1].trap.dec;
  GT_GetTrapPrm(1, &traps[next() + 1]);
  order = traps[1].smoothTime * 10 + calls;
  GT_GetTrapPrm(3, traps);
  GT_GetTrapPrm(1, &list[start]);
  got = traps[0].acc + list[0].dec + list[0].smoothTime * 10;
  set_all(traps, 2);
  GT_GetTrapPrm(2, &list[i]);
  kept = list[1].acc;
  axis[i].trap.acc += 0.5;
  axis[next()].trap.acc++;
  axis[2].trap.smoothTime -= 3;
  traps[i].dec *= 2;
  stepped = axis[1].trap.acc * 10 + axis[2].trap.acc + traps[1].dec * 100 + axis[2].trap.smoothTime;
  axis[2].trap.smoothTime = 70000;
  narrow = axis[2].trap.smoothTime++;
  axis[2] = axis[i];
  axis[0].trap = t;
  t = axis[2].trap;
  traps[next()] = single;
  copied = total(t) * 10 + axis[2].number + total(traps[3]);
  one = axis[0];
  one.trap.dec = 40;
  axis[i] = one;
  moved = total(axis[1].trap) + total(one.trap);
  faster(&axis[i].trap, 3);
  faster(&traps[3], 2);
  faster(&single, 2);
  passed = axis[1].trap.acc * 100 + traps[3].acc * 10 + single.smoothTime;
  sum = all(traps, 4) + all(&traps[1], 2) + all(&axis[2].trap, 1);
  made = best(traps + 2).acc * 100 + renumbered(axis[1], 8).trap.acc;
  axis[2] = renumbered(local[1], 9);
  local_sum = axis[2].number * 100 + axis[2].trap.velStart + local[0].trap.acc + local[i].trap.smoothTime;
  axis[i].servo.pid[1].kp = 2.5;
  axis[i].servo.pid[1].limit = 30;
  axis[i].servo.pid[i].integralLimit = 100000;
  GT_SetPid(1, 1, &axis[i].servo.pid[1]);
  GT_GetPid(1, 1, &axis[0].servo.pid[0]);
  GT_GetPid(1, 1, &one.servo.pid[i]);
  pid = axis[0].servo.pid[0].kp * 10 + axis[0].servo.pid[0].limit + one.servo.pid[1].integralLimit;
  GT_PrfJog(4);
  jogs[1][0].acc = 1.5;
  jogs[i][0].smooth = 0.5;
  GT_SetJogPrm(4, &jogs[i][0]);
  GT_GetJogPrm(4, jogs[0] + 1);
  jog = jogs[0][1].acc * 10 + jogs[0][1].smooth * 100;
  // The axis 4 is in another mode: nothing is read.
  GT_GetTrapPrm(4, &traps[3]);
  refused = traps[3].acc * 10 + traps[3].smoothTime;
  taken = (i ? axis[i] : one).trap.smoothTime * 10 + (t = traps[3], t.acc);
  filled = axis[1].servo.used * 10 + axis[0].servo.used;
  preset = presets[i].acc * 10 + presets[start].dec * 100 + presets[i].smoothTime;
  sizes = sizeof(struct axis) + sizeof traps * 1000 + sizeof axis[0].servo * 1000000;
  //@ assert: axis[1].trap.smoothTime == 5 && traps[3].acc == 20.0 && jogs[1][0].acc == 1.5
  real = axis[1].trap.acc;
}
// expect: set=423, got=52, refused=10, order=41, kept=2, stepped=641, narrow=4464
// expect: copied=49837, moved=8904, passed=614, made=1006, local_sum=927, pid=100055, jog=65
// expect: taken=50, filled=0, preset=85, sizes=120128160, real=6, sum=82427.5, calls=3
