//@ structured
// Initial values that are not known, or have no element.
int a = 1;
int b = a;  // expect error MP241
int c[2] = {1, 2, 3};  // expect error MP242
int d[2] = 5;  // expect error MP243
int e[];  // expect error MP243
int g[2][2] = {1, {2, 3}};  // expect error MP242
int h[2] = {{1}, {2, 3}};  // expect error MP242
int i[2][2] = {{1, 2}, {3}, {}};  // expect error MP242
int j = {1, 2};  // expect error MP242
int k[1024][1024][1024][1024][1024][1024][1024] = {{1}};  // expect error MP016
int a;
int f, f;
void t0() {
  int x;
  double x;  // expect error MP013
  f = x;
}
