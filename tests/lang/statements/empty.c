int v; // expect: v=3
int t0() {
  ;
  v = 3;;
  return 0;
}
