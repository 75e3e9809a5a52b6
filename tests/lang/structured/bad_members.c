//@ structured
struct point { int x; int y; };
struct point { int z; }; // expect error MP013
struct line { struct point from, to; int x, x; }; // expect error MP013
struct self { struct self inner; }; // expect error MP206
struct later l; // expect error MP206
struct large { int a[1000]; int b[25]; }; // expect error MP016
struct point many[513]; // expect error MP016
struct card { TTrapPrm trap; } cards[257]; // expect error MP016
struct point p = {1, 2, 3}; // expect error MP242
struct point w = {.z = 1}; // expect error MP029
struct point r = {[0] = 1}; // expect error MP029
struct point c = p; // expect error MP243
const struct point fixed = {1, 2};
struct size { int width; int height; } size;
struct half { const int set; int free; } half;
struct line broken;
int n;
void g(void) {
  struct point { int y, z; } p = {1};
  n = p.y;
}
void t0(void) {
  struct point a = {1}, b;
  struct line two = {a, .from.x = 1, .to = 2}; // expect error MP206
  n = a.z; // expect error MP029
  n = a; // expect error MP031
  n = a == b; // expect error MP031 // expect error MP031
  n = n.x; // expect error MP029
  a = size; // expect error MP019
  a = n; // expect error MP031
  a = 1; // expect error MP031
  n = a.x.y; // expect error MP029
  fixed.x = 3; // expect error MP233
  fixed = a; // expect error MP233
  half.set = 1; // expect error MP233
  half = half; // expect error MP233
  n = a[0]; // expect error MP031
  a += b; // expect error MP031
  a++; // expect error MP031
  if (a) n = 1; // expect error MP031
  n = (struct point)n; // expect error MP236
  n = l.x + broken.y;
  n = sizeof(struct unknown); // expect error MP236
  n = ((int[2]){1, 2})[0]; // expect error MP236
  a = (struct size){1, 2}; // expect error MP019
  n = (struct unknown){1}; // expect error MP206
  //@ assert: a == 1
  n = 1; // expect error MP141 @48
}
