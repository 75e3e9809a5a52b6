//@ structured
// The structures of the card as members: used by commands, copied, initialised, passed by value.
struct move {
  int axis;
  TTrapPrm trap;
  struct {
    TPid pid;
    double limit;
  } servo;
} first = {1, {2.5, 3, 0.5, 4}, .servo.limit = 8}, second;
int sizes, same, read, status, copies, swapped;
double sum, acc;
static struct move faster(struct move m, double by) {
  m.trap.acc *= by;
  return m;
}
static void exchange(double *a, double *b) {
  double old = *a;
  *a = *b;
  *b = old;
}
static void slower(struct move *m) { m->trap.dec = m->trap.acc / 2; }
void t0(void) {
  TTrapPrm trap = first.trap;
  struct move local = {.trap = {1, 2}, .axis = 3}, other = {7, trap};
  GT_PrfTrap(1);
  first.trap.smoothTime = 5;
  GT_SetTrapPrm(first.axis, &first.trap);
  GT_GetTrapPrm(1, &second.trap);
  read = second.trap.smoothTime;
  acc = second.trap.acc;
  second = faster(first, 3);
  slower(&second);
  sum = second.trap.acc + second.trap.dec + local.trap.acc + local.trap.dec;
  local.trap = second.trap;
  first.trap = local.trap;
  same = first.trap.acc == second.trap.acc && local.axis == 3;
  copies = other.axis * 10 + other.trap.smoothTime;
  GT_GetSts(1, &second.axis, 1, &status);
  exchange(&trap.acc, &trap.dec);
  exchange(&trap.dec, &other.trap.velStart);
  swapped = trap.acc * 1000 + trap.dec * 100 + other.trap.velStart * 10 + trap.smoothTime;
  //@ assert: trap.dec == 0.5 && other.trap.velStart == 2.5
  sizes = sizeof(struct move) * 1000 + sizeof first.trap;
}
// expect: sizes=104032, same=1, read=5, acc=2.5, sum=14.25, copies=74, swapped=3079
