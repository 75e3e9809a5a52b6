//@ structured
#include <stdint.h>
int v;
int64_t a; // expect error MP200
unsigned size_t b; // expect error MP005
int32_t int c; // expect error MP005
uintmax_t d(int_least64_t x) { // expect error MP200 // expect error MP200
  return x;
}
void t0() {
  v = L'x'; // expect error MP201
  v = u8'x'; // expect error MP201
  v = sizeof(uint64_t); // expect error MP200
}
