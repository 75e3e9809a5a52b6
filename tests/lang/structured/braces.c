//@ structured
// A value without braces opens the row that it begins, which takes values until it is full.
// expect: elided[0]=1, elided[1]=2, elided[2]=3, elided[3]=0
// expect: deep[3]=4, deep[4]=5, deep[5]=0, deep[8]=0, deep[12]=0
// expect: empty[4]=5, empty[8]=0, next[4]=5, next[11]=6, next[12]=7, next[23]=0
// expect: rows=3, open[5]=6, local[1]=2, local[2]=3, local[3]=0, scalar=5, zero=0
int elided[3][2] = {1, {2}, 3};
int deep[2][3][4] = {1, 2, 3, 4, {5}};
int empty[2][3][4] = {1, 2, 3, 4, {5}, {}};
int next[2][3][4] = {{1, 2, 3, 4, {5}, 0, 0, 0, 6}, 7};
int open[][2] = {1, 2, {3}, {4, 6}};
int rows, local[4], scalar = {{5}}, zero = {};
void t0() {
  int inner[3][2] = {1, {{2}}, 3}, one = {};
  local[0] = inner[0][0];
  local[1] = inner[0][1];
  local[2] = inner[1][0];
  local[3] = inner[1][1] + one;
  rows = sizeof(open) / sizeof(open[0]);
}
