int v;
int t0() {
  v = 1 // expect error MP041
  v = 2;
  v = ; // expect error MP127
  v = 3 4; // expect error MP041
  ) // expect error MP032
  ;
  v = abs(v; // expect error MP039
  v = abs v; // expect error MP041
  goto; // expect error MP046
  if v) goto l; // expect error MP038
  if (v goto l; // expect error MP039
l:
  return 0;
}
