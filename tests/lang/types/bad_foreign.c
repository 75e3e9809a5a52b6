unsigned long a; // expect error MP114
float b; // expect error MP114
char c; // expect error MP114
unsigned d; // expect error MP114
signed e; // expect error MP114
long long f; // expect error MP114
static int g; // expect error MP115
const int h; // expect error MP115
extern int k; // expect error MP115
int t0() {
  b = 0.5;
  a = 1;
  return 0;
}
