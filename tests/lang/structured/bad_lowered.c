//@ structured
// What the names and types of a program forbid.
const int limit = 3;
int v, rows[2][3], line[4];
double real;
int twice(int a) { return a * 2; }
int first(int row[]) { return row[0]; }
void nothing() {}
int missing(int a);
void t0(int n) {
  const int fixed = n;
  int sized[n];  // expect error MP240
  limit = 4;  // expect error MP233
  fixed++;  // expect error MP233
  v = twice(1, 2);  // expect error MP231
  v = nothing();  // expect error MP232
  v = missing(1);  // expect error MP246
  v = first(rows);  // expect error MP244
  v = unknown;  // expect error MP027
  goto nowhere;  // expect error MP020
  break;  // expect error MP234
  case 1: v = 1;  // expect error MP235
  rows[2][0] = 1;  // expect error MP017
  rows[0][3] = 1;  // expect error MP017
  v = rows[0];  // expect error MP048
  v = real % 2;  // expect error MP028
  v = GT_Update(1);  // expect error MP232
  return 1;  // expect error MP123
}
