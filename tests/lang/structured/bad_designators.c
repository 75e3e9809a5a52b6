//@ structured
int one = 1;
int a[2] = {[2] = 1};  // expect error MP017
int b[2] = {[1] = 1, 2};  // expect error MP242
int c[2] = {[one] = 1};  // expect error MP241
int d[2] = {[-1] = 1};  // expect error MP017
int e[2] = {[1 ... 0] = 1};  // expect error MP017
int f[2] = {[0][0] = 1};  // expect error MP242
int g[2] = {.x = 1};  // expect error MP029
int h = {[0] = 1};  // expect error MP242
int i[] = {[100000] = 1};  // expect error MP017
TTrapPrm j = {[1] = 2};  // expect error MP029
TTrapPrm k = {.speed = 2};  // expect error MP029
int l[2][2] = {[0] = {1, 2, 3}};  // expect error MP242
void t0() {
  int m[3] = {[0 ... 2] = one++};  // expect error MP206
}
