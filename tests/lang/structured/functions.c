//@ structured
// Functions are inserted where they are called: parameters by value, arrays by reference, results
// of every type, prototypes, and names that hide globals.
// expect: sum=21, first=9, row=15, half=2.5, same=4, most=6, calls=3, value=4
int sum, first, row, same, most, calls, value = 4;
double half;
int data[6] = {1, 2, 3, 4, 5, 6}, table[2][3] = {{1, 2, 3}, {4, 5, 6}};
int total(const int values[], int count);
double divide(double a, double b) { return a / b; }
int clear(int value) {
  value = 0;
  calls++;
  return value + 3;
}
int largest(int values[], int count) {
  int best = values[0];
  for (int i = 1; i < count; i++) {
    if (values[i] <= best) continue;
    best = values[i];
    if (best > 5) return best;
  }
  return best;
}
void set(int values[], int at, int to) { values[at] = to; }
void t0() {
  sum = total(data, 6);
  row = total(table[1], 3);
  set(data, 0, 9);
  first = data[0];
  half = divide(5, 2);
  same = value;
  clear(value);
  most = largest(&data[2], clear(0) + clear(1) - 2);
}
int total(const int values[], int count) {
  int s = 0;
  while (count > 0) s += values[--count];
  return s;
}
