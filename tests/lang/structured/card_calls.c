//@ structured
// The structures of the card as parameters, results and by reference.
TTrapPrm first = {1, 2, 0.5, 4}, second = {3, 4, 1.5, 6}, made, read;
int sums, swapped, chosen, after, short_time, sizes;
static double total(TTrapPrm t) {
  t.acc += t.dec;
  return t.acc + t.velStart;
}
static TTrapPrm scaled(TTrapPrm t, double by) {
  t.acc *= by;
  t.dec *= by;
  return t;
}
static void exchange(TTrapPrm *a, TTrapPrm *b) {
  TTrapPrm old = *a;
  *a = *b;
  *b = old;
}
static void set(int axis, TTrapPrm *t) {
  t->smoothTime++;
  GT_SetTrapPrm(axis, t);
}
static void get(int axis, TTrapPrm *t) { GT_GetTrapPrm(axis, t); }
static TTrapPrm larger(const TTrapPrm *a, const TTrapPrm *b) { return a->acc > b->acc ? *a : *b; }
static int size(TTrapPrm *t) { return sizeof t * 100 + sizeof *t; }
struct move {
  int axis;
  TTrapPrm trap;
} move = {1, {7, 8, 9, 10}};
void t0(void) {
  TTrapPrm local = {10, 20}, kept = scaled(first, 2);
  sums = total(first) * 10 + total(scaled(second, 2)) * 1000;
  made = scaled(scaled(local, 2), 0.5);
  exchange(&first, &second);
  exchange(&local, &move.trap);
  exchange(&local, &local);
  swapped = first.acc * 1000 + second.velStart * 100 + local.smoothTime + move.trap.dec;
  chosen = larger(&first, &second).smoothTime * 100 + larger(&kept, &move.trap).dec;
  GT_PrfTrap(1);
  set(move.axis, &first);
  get(1, &read);
  after = read.smoothTime * 100 + first.smoothTime + read.acc;
  set(1, &local);
  get(1, &move.trap);
  short_time = move.trap.smoothTime * 10 + move.axis;
  sizes = size(&local);
}
// expect: sums=15535, made.acc=10, swapped=3080, chosen=620, after=710, short_time=111, sizes=432
