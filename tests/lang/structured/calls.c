//@ structured
// Several calls of a function whose statements stand once: in loops, in conditions, in each other,
// with results, early returns, static locals, and for each array.
// expect: sum=45, nested=7, chosen=2, count=9, low=1, high=9, part=12, chain=47
int sum, nested, chosen, count, low, high, part, chain;
int first[4] = {4, 1, 3, 2}, second[4] = {9, 5, 7, 8};
int bounded(int x, int limit) {
  static int calls;
  count = ++calls;
  if (x < 0) return 0;
  if (x > limit) {
    x = limit;
    if (x % 2) return x;
  }
  return x - x / limit;
}
int smallest(int values[], int from) {
  int best = values[from];
  for (int i = from + 1; i < 4; i++)
    if (values[i] < best) best = values[i];
  return best;
}
int three(int x) {
  int y = smallest(first, 0) + x;
  while (y < 20) y += smallest(first, 0) + smallest(second, x & 3);
  return y;
}
void t0() {
  for (int i = 0; i < 10; i++) sum += i;
  nested = bounded(bounded(bounded(30, 9) + 3, 11), 7);
  if (bounded(-1, 5) || bounded(4, 9) > 5) chosen = 1;
  else chosen = bounded(2, 3) && !bounded(-5, 3) ? 2 : 3;
  low = smallest(first, 0);
  high = bounded(40, smallest(second, 0) + 4);
  part = smallest(first, 2) + smallest(second, 1) + smallest(second, 2) - smallest(first, 3) + bounded(0, 1);
  chain = three(1) + three(2);
}
