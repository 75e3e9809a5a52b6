//@ structured
// What each call of a function that calls itself has of its own cannot be referred to by another.
int v;
//@ depth: 4

void count(int n, int *to) {
  int mine = 0, list[3] = {0};
  if (n == 0) return;
  count(n - 1, &mine); // expect error MP236
  count(n - 1, list); // expect error MP236
  *to += mine + list[0];
}
void t0() {
  count(3, &v);
}
