//@ structured
int a[4], n;
double real;
const int fixed[2] = {1, 2};
TTrapPrm trap;
typedef int rows[2][2];
rows m;
static void set(int *place) { *place = 1; } // expect error MP233
static int get(const int *place) { return *place; }
static void wide(int place[][3]) { place[0][0] = 1; }
static int at(int *place, int i) { return place[i]; } // expect error MP236
static int third(int *place) { return place[2]; } // expect error MP017
void t1(int *place) { *place = 1; } // expect error MP245
void t0() {
  n = *n; // expect error MP203
  n = &n; // expect error MP204
  n = **a; // expect error MP203
  set(n); // expect error MP031
  set(&real); // expect error MP244
  set(fixed);
  set(&trap.acc); // expect error MP244
  set(m); // expect error MP244
  set(0); // expect error MP031
  set(&1); // expect error MP031
  set(n ? a : a); // expect error MP031
  wide(m); // expect error MP244
  n = get(&n) + get(fixed + 1) + at(&n, n) + third(&a[2]);
  n = *(a + 4); // expect error MP017
  n = *(a - 1); // expect error MP017
}
