//@ structured
// Structures as parameters, results and by reference.
struct point {
  int x;
  int y;
};
struct axis {
  struct point at;
  short gains[3];
  double speed;
} axis[3] = {{{1, 2}, {3, 4, 5}, 0.5}, {{6, 7}, {8, 9, 10}, 1.5}, {{11, 12}}};
struct point p = {1, 2}, q = {30, 40}, made, chosen, twice;
int dot, copied, sum, member, moved, aliased, first, kept, walked, nested, between, row, sizes, fields, i, whole, unwanted;
static struct point add(struct point a, struct point b) {
  a.x += b.x;
  a.y += b.y;
  return a;
}
static struct point swapped(struct point a) { return a.x > 10 ? (a.x = 9, a) : add(a, a); }
static int product(const struct point *a, const struct point *b) { return a->x * b->x + (*a).y * b->y; }
static void move(struct point *place, int by) {
  place->x += by;
  place->y = place->x--;
}
static void exchange(int *a, int *b) {
  int old = *a;
  *a = *b;
  *b = old;
}
static void both(struct point *a, struct point *b) {
  struct point old = *a;
  *a = *b;
  *b = old;
}
static struct axis tuned(struct axis one, int gain) {
  one.gains[gain] = 70;
  one.at = add(one.at, (one.at));
  return one;
}
static int total(const short *gains, int count) {
  int s = 0;
  while (count-- > 0) s += *gains++;
  return s;
}
static int walk(struct axis *a, struct axis *end) {
  int s = 0;
  for (; a < end; a++) s = s * 20 + a->at.x + total(a->gains, 2);
  return s;
}
static void set(struct point *place, int *index) {
  *index = 0;
  place->y = 90;
}
static int size(struct axis *a) { return sizeof a + sizeof *a * 10 + sizeof a->gains * 1000; }
static struct point last(struct axis *a, int n) { return a[n - 1].at; }
void t0(void) {
  struct point local[2] = {{5, 6}, {7, 8}}, one;
  made = add(p, add(q, p));
  twice = swapped(swapped(p));
  dot = product(&p, &q) + product(&local[1], local);
  copied = p.x * 10 + q.y;
  sum = add(p, q).x + add(axis[1].at, local[0]).y * 100;
  move(&local[1], 3);
  move(&axis[2].at, 4);
  moved = local[1].x * 100 + local[1].y;
  exchange(&local[0].x, &axis[0].at.y);
  exchange(&p.x, &p.x);
  member = local[0].x * 100 + axis[0].at.y;
  both(&local[0], &local[0]);
  both(&p, &q);
  aliased = local[0].x * 1000 + p.x * 10 + q.x;
  axis[1] = tuned(axis[0], 1);
  first = axis[1].gains[1] * 100 + axis[1].at.y + axis[0].gains[1];
  i = 1;
  set(&axis[i].at, &i);
  kept = axis[1].at.y * 10 + i;
  walked = walk(axis, axis + 3);
  nested = total(&axis[1].gains[1], 2) * 100 + total(axis[0].gains, 3);
  i = 2;
  chosen = last(&axis[i - 2], i);
  one = i > 1 ? add(p, p) : q;
  between = one.x + (i ? p : q).y;
  row = walk(&axis[1], &axis[2]) - walk(axis, axis);
  sizes = size(axis);
  add(p, q);
  whole = axis[2].at.x * 100 + axis[2].at.y;
  i = 0;
  p;
  unwanted = (q, axis[i++], axis[i++].at, add(p, q), i);
}
// expect: made_x=32, made_y=44, twice_x=4, twice_y=8, dot=193, copied=50, sum=1331, moved=910
// expect: member=205, aliased=2301, first=7014, kept=900, walked=4714, nested=7512, chosen_x=2
// expect: unwanted=2, chosen_y=90, between=100, row=75, sizes=6244, whole=1415, p_x=30, q_y=2, axis_at_y[0]=5
