//@ structured
int a
double b; // expect error MP041 @2
void t0() {
  int i
  for (i = 0; i < 3; i++ { // expect error MP041 @5 // expect error MP039
    a = 1;
  }
  i = = 3; // expect error MP127
  i = a ? 2; // expect error MP131
  i = (a ? 2); // expect error MP131
  switch (i) {
    case 1 a = 2; break; // expect error MP131
    default a = 3; // expect error MP131
  }
  do { i++; } while (i < 3) // expect error MP041
  i = 1;
  else i = 1; // expect error MP032
  a[2 = 3; // expect error MP042
  i = (a + 2; // expect error MP039
}
int e[3] = {1, 2 3}; // expect error MP131
int f0[2] = {(1 2), 3}; // expect error MP039
int *const f; // expect error MP129
int g = sizeof int; // expect error MP038
int h = sizeof(int;  // expect error MP039
untyped() { // expect error MP005
  return 1;
}
untyped_too(int a) { // expect error MP005
  return 1;
}
int i = a ? 1 : 2;
void t1() {
  a = 1;
// expect error MP004 @36
