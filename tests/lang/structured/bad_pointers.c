//@ structured
int *p; // expect error MP129
int a, *q = 0, b; // expect error MP129
int *next(int x) { // expect error MP129
  return 0;
}
void f(int **out); // expect error MP129
void g(int *out[2]); // expect error MP129
void h(TTrapPrm **trap); // expect error MP129
void t0() {
  int c, d;
  d = (int *) c; // expect error MP203
  d = sizeof(int *); // expect error MP203
  GT_GetSts(1, &c, 1, &d);
  a = (c ? t0 : t1)(); // expect error MP205
  (*a)(); // expect error MP205
}
