int i, a[3];
double d;
int t0() {
  i = a[3]; // expect error MP017
  i = a[-1]; // expect error MP017
  i = a[1.0]; // expect error MP018
  i = a[d]; // expect error MP018
  i = a[i + 1]; // expect error MP018
  i = a[a[0]]; // expect error MP112
  i = a[missing]; // expect error MP027
  i = a[i][0]; // expect error MP028
  return 0;
}
