#define N 1
#define N 2 // expect error MP013
int t0() { return N; }
