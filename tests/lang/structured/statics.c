//@ structured
// A static local keeps its value; globals have their initial values before a thread uses them.
// expect: v=6, w=14, x=2.5, y=8, z=0
int v, w, y = 8, z = 0;
double x = 2.5;
enum { STEP = 2, LIMIT = STEP * 3 };
int next() {
  static int count = STEP;
  count += STEP;
  return count;
}
void t0() {
  int i;
  for (i = 0; i < 2; i++) v = next();
  w = y + LIMIT;
}
