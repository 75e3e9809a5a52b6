//@ structured
// The integer types of C's headers have their sizes, also without the header, and limits.h and
// stdint.h their numbers.
#include <limits.h>
#include <stdbool.h>
#include <stddef.h>
#include "stdint.h"
#if INT_MAX != 2147483647 || !(INT32_MIN < 0) || UINT_MAX != 4294967295
#error the conditions know the macros
#endif
int8_t a;
uint8_t b;
int16_t c;
uint16_t d;
int32_t e;
uint32_t f;
size_t g;
ptrdiff_t h;
uint_least8_t i;
int_fast16_t j;
int sizes, low, high, wide, least, limits;
static uint32_t add(uint8_t x, const int16_t y) { return x + (uint8_t)y; }
void t0(void) {
  a = 200;
  b = -1;
  c = 40000;
  d = -1;
  e = INT_MIN;
  f = 3;
  g = sizeof(int_fast16_t);
  h = -5;
  i = 257;
  j = 70000;
  sizes = sizeof a * 1000 + sizeof(uint16_t) * 100 + sizeof c * 10 + sizeof(intptr_t);
  low = SCHAR_MIN + SHRT_MIN;
  high = UCHAR_MAX + USHRT_MAX + CHAR_BIT;
  wide = -1 > (uint32_t)0;
  least = e == -2147483647 - 1;
  limits = UINT32_MAX > 0 && LONG_MAX == INT32_MAX && SIZE_MAX == UINT_MAX;
  f = add(260, 300);
}
// expect: a=-56, b=255, c=-25536, d=65535, f=48, g=4, h=-5, i=1, j=70000, sizes=1224
// expect: low=-32896, high=65798, wide=1, least=1, limits=1
