//@ structured
// Structures and numbers without a name.
struct point {
  int x, y;
};
struct line {
  struct point from, to;
} line = {{1, 2}, {3, 4}};
int sum, swapped, length, number, chosen, member, size;
static int product(struct point p) { return p.x * p.y; }
static void move(struct point *p, int by) { p->x += by, sum += p->x; }
void t0(int n) {
  struct point p = {5, 6};
  p = (struct point){p.y, p.x};
  swapped = p.x * 10 + p.y;
  length = product((struct point){.y = 3, .x = p.x}) + product((const struct point){7});
  line = (struct line){line.to, {.x = n + 9}};
  number = (int){p.x + 1} + (short){70000};
  move(&(struct point){10, 20}, 5);
  chosen = (n ? p : (struct point){8, 9}).y;
  member = (struct line){{1}, {2, 3}}.to.y;
  size = sizeof(struct line){{0}} + sizeof((struct point){0}.x);
  for (int i = 0; i < 2; i++) sum += (struct point){i}.x * 100 + (struct point){i}.y;
  if (sum) {
    sum++;
  }
}
// expect: line_from_x=3, line_to_x=9, line_to_y=0, sum=116, swapped=65, length=18, number=4471
// expect: chosen=9, member=3, size=20
