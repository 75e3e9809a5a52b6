//@ structured
int a[4], c[4], n;
static void move(int *p) { p++; }
static void change(int *p, int *q) { p = q; } // expect error MP236
static int compare(int *p, int *q) { return p < q; } // expect error MP236
static int value(int *p) { return p++ > 0; } // expect error MP048
static void scale(int *p) { p *= 2; } // expect error MP048
void t0() {
  move(&n); // expect error MP236
  move(a);
  change(a, c);
  n = compare(a, c) + value(a);
  scale(a);
  a++; // expect error MP031
  a = c; // expect error MP031
}
