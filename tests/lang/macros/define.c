#define ONE 1
#define MINUS (-2)
#define HALF 0.5
#define ALSO ONE
int a, b, c;
double d;
#define AFTER 7
int t0() {
  a = ONE;
  b = MINUS;
  c = ALSO + AFTER;
  d = HALF;
  return 0; // expect: a=1, b=-2, c=8, d=0.5
}
