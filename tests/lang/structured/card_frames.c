//@ structured
// Structures of the card of which each call of a function has its own.
int order, counted, sums, unread, once;
struct leg {
  int axis;
  TTrapPrm trap;
};
//@ depth: 4
static int restored(int n) {
  TTrapPrm trap;
  GT_GetTrapPrm(n, &trap);
  trap.acc += n;
  if (n > 1) {
    int rest = restored(n - 1);
    order = order * 100 + rest;
  }
  GT_SetTrapPrm(n, &trap);
  return trap.acc * 10 + trap.smoothTime;
}
//@ depth: 4
static TTrapPrm summed(int n, TTrapPrm own) {
  TTrapPrm rest = {0};
  own.acc *= n;
  if (n > 0) rest = summed(n - 1, own);
  rest.acc += own.acc;
  rest.smoothTime += own.smoothTime + n;
  return rest;
}
//@ depth: 3
static int legs(int n) {
  struct leg leg = {n, {n, n * 2, 0, n * 3}};
  if (n > 0) {
    int rest = legs(n - 1);
    counted += rest * 10;
  }
  leg.trap.dec++;
  return leg.axis + leg.trap.acc + leg.trap.dec + leg.trap.smoothTime;
}
// What is written again, or read before the call alone, is not kept.
//@ depth: 3
static void again(int n) {
  TTrapPrm trap = {n, 1, 0, 1};
  unread = unread * 10 + trap.acc;
  if (n > 0) again(n - 1);
  trap.acc = n + 5;
  once = once * 10 + trap.acc;
}
void t0() {
  TTrapPrm start = {1, 2, 0, 4}, made;
  GT_PrfTrap(1);
  GT_PrfTrap(2);
  GT_PrfTrap(3);
  GT_SetTrapPrm(1, &start);
  start.acc = 3;
  GT_SetTrapPrm(2, &start);
  start.smoothTime = 7;
  GT_SetTrapPrm(3, &start);
  made.acc = restored(3);
  order = order * 100 + made.acc;
  GT_GetTrapPrm(2, &made);
  order += made.acc * 1000000;
  start.acc = 2;
  made = summed(3, start);
  sums = made.acc * 100 + made.smoothTime;
  made.acc = legs(2);
  counted += made.acc;
  again(2);
}
// expect: order=5245467, counted=105, sums=3034, unread=210, once=567
