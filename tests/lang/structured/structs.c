//@ structured
// Structures: members of all types, nested, copied, initialised, as globals, statics and locals.
struct point {
  int x;
  int y;
};
typedef struct {
  struct point from, to;
  unsigned char tag;
  double weight;
} line;
enum kind { kNone, kSome = 7 };
struct mixed {
  enum kind kind;
  int8_t small;
  unsigned short wide;
  bool flag;
} m;
struct point p = {3, 4}, origin, q = {.y = 9};
line one = {{1, 2}, {3}, 300, 0.5}, two = {5, 6, 7, 8, .weight = 1.5};
static const struct point fixed = {11, 12};
int sum, chain, local, stepped, old, chosen, hidden, count, comma, nested, constant, p_x = 40;
int flags;
static void tick(void) {
  static struct point ticks = {100};
  ticks.x++;
  ticks.y += ticks.x;
  count = ticks.x * 1000 + ticks.y;
}
void t0(void) {
  struct point a = {1, 2}, b = a, c;
  struct point empty = {};
  c.x = 10;
  c.y = c.x++ * 2;
  origin = c = b;
  sum = a.x + b.y * 10 + origin.x * 100 + (p = b).y * 1000;
  stepped = c.x++ + ++c.y;
  old = c.x * 10 + c.y;
  chain = (a = b = p).x + empty.x + empty.y;
  a = p_x > 30 ? q : b;
  chosen = a.y;
  {
    struct point {
      int z;
    } p = {77}, other;
    other = p;
    hidden = other.z;
  }
  one.to = q;
  one.from.x += 20;
  one.tag += 250;
  one.weight *= 3;
  two = one;
  nested = two.from.x * 1000 + two.to.y * 100 + two.tag;
  comma = (sum++, two).from.y;
  m.kind = kSome;
  m.small = 200;
  m.wide = 70000;
  m.flag = 256;
  flags = m.kind + m.small + m.wide + m.flag;
  constant = fixed.x * 100 + fixed.y;
  tick();
  tick();
  //@ assert: c.x == 2 && one.from.x > 20
  local = sizeof(struct point) + sizeof p * 10 + sizeof(line) * 100 + sizeof one.from.y;
}
// expect: p_x=40, q_y=9, one_tag=38, one_weight=1.5, two_weight=1.5, origin_x=1, origin_y=2
// expect: sum=2122, stepped=4, old=23, chain=1, chosen=9, hidden=77, nested=21938, comma=2
// expect: count=102203, constant=1112, flags=4416, local=3292
