//@ structured
long long a; // expect error MP200
unsigned long long int b; // expect error MP200
float c; // expect error MP114
long double d; // expect error MP114
short long e; // expect error MP005
unsigned double f; // expect error MP005
int double g; // expect error MP005
u32 h; // expect error MP005
static i; // expect error MP005
void j; // expect error MP005
TCrdPrm l; // expect error MP005
unsigned signed m; // expect error MP005
short char n; // expect error MP005
int o(static int p); // expect error MP005
int q(extern int p); // expect error MP005
void r(void s); // expect error MP005
int v(void, int w); // expect error MP005
void t0() {
  int a;
  a = (float) a; // expect error MP114
  a = sizeof(long long); // expect error MP200
  (void) a;
}
