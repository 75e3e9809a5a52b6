//@ structured
// Parameters that stand for rows of the caller, as C declares pointers to them.
int m[3][4] = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}}, cube[2][2][3], plain[5] = {1, 2, 3, 4, 5};
int all, part, second, walked, distance, sizes, lent, written, deep, one;
double gains[2][2] = {{0.5, 1.5}, {2.5, 3.5}}, gain;
static int sum(int (*)[4], int);
static int sum(int (*rows)[4], int count) {
  int s = 0;
  for (int i = 0; i < count; i++)
    for (int j = 0; j < 4; j++) s += rows[i][j];
  return s;
}
static int corners(int (*rows)[4]) { return (*(rows + 1))[2] + (*rows)[3] * 100 + **rows * 10000; }
static int walk(const int (*row)[4], const int (*end)[4]) {
  int s = 0;
  while (row < end) s = s * 20 + (*row++)[0];
  return s;
}
static int apart(int (*const a)[4], int (*const b)[4]) { return b - a; }
static int size(int (*rows)[4]) { return sizeof rows + sizeof *rows * 10 + sizeof rows[0][0] * 1000; }
static int lend(int (*rows)[4]) { return sum(rows + 1, 1); }
static void clear(int (*rows)[4], int row) {
  for (int j = 0; j < 4; j++) rows[row][j] = 0;
}
static int inner(int (*boxes)[2][3]) { return boxes[1][0][2] * 10 + (*boxes)[1][1]; }
static int number(int(*place)) { return *place + place[1]; }
static double diagonal(double (*of)[2]) { return of[0][0] + of[1][1]; }
void t0(void) {
  all = sum(m, 3);
  part = sum(&m[1], 2);
  second = corners(m + 1);
  walked = walk(m, m + 3);
  distance = apart(m, &m[2]);
  sizes = size(m);
  lent = lend(m);
  clear(m + 1, 1);
  written = m[1][0] + m[2][0] + m[2][3];
  cube[1][0][2] = 7;
  cube[0][1][1] = 8;
  deep = inner(cube);
  one = number(plain + 2);
  gain = diagonal(gains);
}
// expect: all=78, part=68, second=50811, walked=509, distance=2, sizes=4164, lent=26, written=5
// expect: deep=78, one=7, gain=4
