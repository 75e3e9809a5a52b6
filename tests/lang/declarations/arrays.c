#define SIZE 3
int a[SIZE], n;
double d[2];
int t0() {
  int i;
  n = 0;
  i = 2;
  a[0] = 10;
  a[1] = 20;
  a[i] = 30;
  n = a[i] + a[1];
  d[1] = 0.5;
  return 0; // expect: n=50, a[2]=30, d[1]=0.5
}
