//@ structured
struct point { int x; int y; };
struct size { int width; int height; } size;
struct point p;
const struct point fixed = {1, 2};
TTrapPrm trap;
int n;
static void set(struct point *place) { place->x = 1; } // expect error MP233
static int get(const struct point *place) { return place->z; } // expect error MP029
static struct point make(struct point from) { return size; } // expect error MP019
static void later(struct unknown a) {} // expect error MP206
static void away(struct point *place) { place++; }
static int at(struct point *place, int i) { return place[i].x; } // expect error MP236
static void none(void) {}
struct line { struct point from, to; } lines[2];
static void change(struct point *place, struct line *line) { place = line; } // expect error MP236
static int before(struct point *place, struct line *line) { return place < line; } // expect error MP236
static struct unknown new(void) {} // expect error MP206
struct huge { int a[2000]; } huge = {1}; // expect error MP016
struct point t1(void) { return p; } // expect error MP236
void t2(struct point a) { n = a.x; } // expect error MP245
void t0(void) {
  set(p); // expect error MP244
  set(&size); // expect error MP244
  set(&n); // expect error MP244
  set(&fixed);
  set(&make(p)); // expect error MP031
  n = get(&p);
  p = make(size); // expect error MP244
  p = make(1); // expect error MP031
  p = make(p);
  n = make(p); // expect error MP031
  p = none(); // expect error MP232
  n = p->x; // expect error MP203
  n = size.width->x; // expect error MP203
  trap->acc = 1; // expect error MP203
  later(p);
  new();
  change(&lines[0].from, lines);
  n = before(&lines[0].from, lines);
  n = huge.b;
  away(&p); // expect error MP236
  n = at(&p, n);
}
