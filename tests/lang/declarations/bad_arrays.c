int none[0]; // expect error MP016
int minus[-1]; // expect error MP016
int large[1025]; // expect error MP016
int real[2.5]; // expect error MP016
int open[]; // expect error MP016
int n;
int by_variable[n]; // expect error MP016
int unknown[LATER]; // expect error MP027
int square[2][3]; // expect error MP111
int t0() {
  none[0] = 1;
  square[1][2] = 4;
  n = square[n][0];
  return 0;
}
