//@ structured
// Parameters that stand for numbers and arrays of the caller, by C's notations.
int a[6] = {1, 2, 3, 4, 5, 6}, m[2][3] = {{1, 2, 3}, {4, 5, 6}}, g = 5, alias, same, sizes, kept;
int sum1, sum2, before, row, nested, status, deep;
double half = 0.5;
unsigned char byte = 250;
static void swap(int *x, int *y) {
  int t = *x;
  *x = *y;
  *y = t;
}
static int sum(const int *list, int count) {
  int s = 0;
  for (int i = 0; i < count; i++) s += *(list + i);
  return s;
}
static void divide(int n, int by, int *quotient, int *rest) {
  *quotient = n / by;
  *rest = n % by;
}
static void twice(double *x, unsigned char *b) {
  *x *= 2;
  *b += 10;
}
static int both(int *x, int *y) {
  *x = 1;
  *y += 1;
  return *x;
}
static void element(int *place, int *index) {
  *index = 0;
  *place = 70;
}
static int back(int *const end) { return end[-1] + *(end - 2); }
static int middle(int rows[][3]) { return sum(rows[1], 3) + sum(*rows, 1); }
static void outer(int *x) {
  swap(x, &a[5]);
  swap(&*x, &x[1]);
}
static int size(int list[10], int *place) { return sizeof list + sizeof(place) * 10 + sizeof *place * 100; }
static int depth3(int *x) { return ++*x; }
static int depth2(int *x) { return depth3(x) + depth3(x); }
void t0(void) {
  int i = 2, j = 3, q, r, values[3] = {7, 8, 9};
  swap(&i, &j);
  swap(&a[i], &a[j]);
  same = a[i];
  swap(&a[0], &a[0]);
  sum1 = sum(a, 6);
  sum2 = sum(a + 2, 2) + sum(&a[1], 1) * 100 + sum(1 + values, 2) * 1000;
  divide(17, 5, &q, &r);
  status = q * 10 + r;
  twice(&half, &byte);
  g = 4;
  alias = both(&g, &g);
  i = 4;
  element(&a[i], &i);
  kept = a[4] * 10 + i;
  before = back(a + 3);
  row = middle(m);
  outer(values);
  nested = values[0] * 100 + values[1] * 10 + a[5];
  sizes = size(a, &q);
  deep = 1;
  j = depth2(&deep);
  deep = deep * 10 + j;
}
// expect: a[0]=1, a[1]=2, same=3, a[3]=3, a[2]=4, sum1=21, sum2=17207, status=32
// expect: half=1, byte=4, alias=2, g=2, kept=700, before=6, row=16, nested=867, sizes=444, deep=35
