int scale, ratio[2], known;
double step;
int t0(int n) {
  double d;
  known = 4;
  n = n / scale; // expect warning MP135
  n = n % scale;
  n = n % ratio[n]; // expect warning MP135
  n = n / known;
  d = 1.0 / step; // expect warning MP135
  known = (int) d;
  return n;
}
