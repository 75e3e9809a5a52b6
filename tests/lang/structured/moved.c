//@ structured
// Parameters that a function moves within the array of its caller.
int a[6] = {1, 2, 3, 4, 5, 6}, b[6], m[3][2] = {{1, 2}, {3, 4}, {5, 6}}, where, first, ends, rows;
int nested, stays;
double reals[3] = {0.5, 1.5, 2}, half;
static void copy(int *to, const int *from, int count) {
  while (count-- > 0) *to++ = *from++;
}
static int sum(int list[], const int *end) {
  int s = 0;
  for (; list < end; ++list) s = s * 10 + *list;
  return s;
}
static int distance(const int *list, int value) {
  const int begin = 0;
  int n = 0;
  while (*list != value && n < 5) list++, n++;
  return n + begin;
}
static int gap(int *p, int *q) {
  p += 2;
  q = p;
  q -= 1;
  return (p - q) * 10 + (p > q) + (p == q + 1);
}
static int walk(int grid[][2]) {
  int s = 0;
  for (int i = 0; i < 3; i++, grid++) s = s * 10 + (*grid)[1] + grid[0][0];
  return s;
}
static double last(double *p) {
  p += 2;
  return *p - *(p - 1);
}
static int inner(int *p) {
  int v = *p++;
  return v * 10 + *p;
}
static int outer(int *p) {
  int v = inner(p);
  p++;
  return v * 100 + inner(p);
}
static void raise(int *p) {
  *p++ += 5;
  (*p)++;
  ++*p;
  p[-1] *= 2;
}
void t0(void) {
  int i = 1;
  copy(b, &a[i], 5);
  copy(b + 5, a, 1);
  first = sum(b, b + 3);
  where = distance(a, 4);
  ends = gap(a, a + 5);
  rows = walk(m);
  half = last(reals);
  nested = outer(&a[i]);
  raise(&b[i]);
  stays = b[1] * 100 + b[2];
}
// expect: b[0]=2, b[3]=5, b[4]=6, b[5]=1, first=234, where=3, ends=12, rows=381, half=0.5
// expect: nested=2334, stays=1606
