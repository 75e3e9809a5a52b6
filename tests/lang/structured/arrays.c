//@ structured
// Arrays with several dimensions, two of them in one statement, and tables with and without sizes.
// expect: a=12, b=6, c=3, d=0, e=9, f=8, m[5]=7, size=3
int a, b, c, d, e, f, size, m[2][3];
const int squares[] = {0, 1, 4, 9};
int partial[2][3] = {1, 2, 3, 4};
void t0() {
  int n[3][2] = {{1, 2}, {3, 4}, {5, 6}}, i = 1, zero[20] = {0, 5};
  m[i][i + 1] = 7;
  a = m[i][2] + n[2][i - 1];
  b = n[2][1];
  c = partial[0][2];
  d = partial[1][1] + zero[19];
  e = squares[3];
  f = n[i][i] + n[i][i];
  size = sizeof(n) / sizeof(n[0]);
}
