int t0() {
  late = 1; // expect error MP027
  late = 2;
  return 0;
}
int late;
int t1() {
  late = 3;
  return 0;
}
