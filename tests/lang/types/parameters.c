double out;
double scale(long count, double factor, short k) { // expect ok
  double x;
  x = (double) count;
  out = x * factor;
  return out;
}
