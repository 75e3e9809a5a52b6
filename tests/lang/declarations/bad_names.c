int a;
int a; // expect error MP013
int f() { return 0; }
int f() { return 1; } // expect error MP013
int f; // expect error MP013
#define a 1 // expect error MP013
int GT_Update; // expect error MP013
int t0(int x, int x) { // expect error MP013
  int y;
  int y; // expect error MP013
  int a; // expect error MP125
  return 0;
}
