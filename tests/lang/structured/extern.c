//@ structured
// A global may be declared before it is defined, also in a function, and several functions in one
// list.
extern int late, list[];
extern double half;
extern const int LIMIT;
int first(void), second(int), third(int a, int b);
extern int fourth(void);
extern int unused;
int rows = sizeof(LIMIT), hidden, shown, size, value, calls;
void t0(void) {
  extern int after;
  extern double half;
  int late2 = LIMIT;
  {
    int late = 5;
    hidden = late;
    {
      extern int late;
      shown = late;
    }
  }
  after = late2;
  size = sizeof list / sizeof list[0];
  list[2] = late + after;
  half = 0.5;
  value = half * 8;
  calls = first() * 1000 + second(2) * 100 + third(1, 2) * 10 + fourth();
}
int late = 7, list[3] = {1}, after;
extern int late;
double half;
const int LIMIT = 40;
int first(void) { return 1; }
int second(int a) { return a; }
int third(int a, int b) { return a + b; }
int fourth(void) { return 4; }
// expect: rows=4, hidden=5, shown=7, size=3, value=4, after=40, list[2]=47, list[0]=1, calls=1234
