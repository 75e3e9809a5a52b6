//@ structured
extern int nowhere; // expect error MP206
extern int table[]; // expect error MP206
extern int a;
double a; // expect error MP013
extern int list[2];
int list[3]; // expect error MP013
int twice = 1;
int twice = 2; // expect error MP013
int once = 1;
extern int once;
void t0(void) {
  extern int missing; // expect error MP206
  extern int once = 3; // expect error MP206
  twice = nowhere + nowhere;
  table[0] = table[1];
}
