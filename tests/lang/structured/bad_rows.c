//@ structured
int m[3][4], plain[5], v;
static int sum(int (*rows)[4], int n) { return rows[n][0]; }
static int open(int (*rows)[]) { return rows[0][0]; } // expect error MP236
static void set(const int (*rows)[4]) { rows[0][0] = 1; } // expect error MP233
void t0() {
  v = sum(plain, 1); // expect error MP244
  v = sum(&v, 1); // expect error MP244
  set(m);
  v = open(m);
}
