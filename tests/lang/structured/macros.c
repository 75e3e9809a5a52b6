//@ structured
#ifndef MACROS_C
#define MACROS_C
#define SQUARE(x) ((x) * (x))
#define CLEAR(a, count)         \
  do {                          \
    int i;                      \
    for (i = 0; i < (count); i++) a[i] = 0; \
  } while (0)
#define COUNT (2 * 4)
int a[COUNT];
void t0() {
  CLEAR(a, COUNT);
#if COUNT > 4
  a[SQUARE(2)] = 1;
#endif
}
#endif
