/* one */ int v; // two
/* a // in it * and another / */
int t0() {
  v = 1; /* in /* not nested */ // expect ok
  return 0; // expect: v=1
}
