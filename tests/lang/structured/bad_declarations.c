//@ structured
int v;
void f(void *p) {} // expect error MP129
void g(int *, int k) {} // expect error MP128
int up(int a), down(int a);
int left(void), *right(int a), both(); // expect error MP129
int up(int a) { return a; }
__attribute__((noinline)) int attributed(int a) { return a; } // expect warning MP218
int aligned __attribute__((aligned(4), unused)); // expect error MP206 // expect warning MP218
__attribute__((__packed__)) int packed; // expect error MP206
typedef unsigned char byte;
byte first;
void t0() {
  void *p; // expect error MP129
  byte third = 1;
  int *q = 0, r; // expect error MP129
  v = third + first + attributed(1) + up(aligned) + down(1);
}
