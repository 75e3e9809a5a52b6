//@ structured
// Functions that call themselves, alone or in a circle.
int v, w;
int odd(int n);
int even(int n) { return n == 0 ? 1 : odd(n - 1); }  // expect error MP230
int odd(int n) { return n == 0 ? 0 : even(n - 1); }
int self(int n) { return n ? self(n - 1) + 1 : 0; }  // expect error MP230
void t1(int n) { // expect error MP236
  if (n > 0) t1(n - 1);
  v++;
}
void t0() {
  v = even(w) + self(w);
}
