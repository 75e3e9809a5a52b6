/* double is a fixed-point number with 16 fractional bits: a multiple of 1/65536 (GTS manual
   10.4.1). Products and quotients are truncated, not rounded. */
double third;
double tenth;
double area;

int divide(void)
{
  double seven;

  seven = 7.0;
  third = seven / 3.0;
  tenth = 0.1;
  return 0;
}

double square(double side)
{
  area = side * side;
  return area;
}

/* A cast to int drops the fraction: it rounds towards zero. */
int whole(double x)
{
  int i;

  i = (int)x;
  return i;
}
