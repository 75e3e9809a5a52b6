// options: double=16.16
double d;
int t0() {
  d = 32768.0; // expect error MP026
  d = 32767.99998;
  d = -32768.0;
  d = 40000; // expect error MP026
  return 0;
}
