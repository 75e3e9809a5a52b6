int sum;
int t0(int count) {
  int i, a[4];
  TPid pid;
  sum = sum + count;
  sum = sum + i; // expect warning MP133
  sum = sum + i;
  sum = a[2]; // expect warning MP133
  sum = pid.limit; // expect warning MP133
  return sum;
}
