// As structured C all but the last of these would be right: then there would be one error.
int a, b, c;
int t0() {
  a += 2; // expect error MP106
  a <<= 1; // expect error MP106
  a++; // expect error MP107
  --b; // expect error MP107
  a = -b; // expect error MP108
  a = b = c; // expect error MP100
  a = b * c + 1; // expect error MP100
  a = (b); // expect error MP100
  a = (int) (b + 1); // expect error MP100
  a = abs(b - c); // expect error MP100
  a = 1, b = 2; // expect error MP100
  d = 1; // expect error MP027
  return 0;
}
