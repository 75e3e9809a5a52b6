//@ structured
// Attributes that change nothing are ignored, with a remark about the first of each kind.
int v, w;
#define PURE __attribute__((__pure__, const))
static int twice(int a) __attribute__((noinline, unused)); // expect warning MP218 // expect warning MP218
PURE static int twice(int a) { return 2 * a; } // expect warning MP218 // expect warning MP218
__extension__ int x; // expect warning MP218
PURE int thrice(int restrict a) { return 3 * a; } // expect warning MP218
void t0(void) {
  int unused __attribute__((unused)) = 1;
  switch (w) {
    case 0:
      v = twice(4);
      __attribute__((format(printf, 1, 2), fallthrough)); // expect warning MP218 // expect warning MP218
    case 1:
      v += thrice(1);
  }
}
// expect: v=11
