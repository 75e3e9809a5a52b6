//@ structured
// The spellings of gcc's own words that mean nothing to the card.
// expect: v=6
int v;
static __inline__ int twice(int x) { return 2 * x; }
__inline int thrice(__volatile__ int x) { return 3 * x; }
void t0() {
  __volatile int one = 1;
  v = twice(thrice(one));
}
