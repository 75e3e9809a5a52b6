//@ structured
typedef int row[2];
typedef int word;
typedef double word; // expect error MP013
typedef int open[]; // expect error MP240
typedef int set = 1; // expect error MP206
row result(void) { return 0; } // expect error MP236
row many[1000]; // expect error MP016
void t0(row first) { // expect error MP245
  word a = 1;
  row b = 1; // expect error MP243
}
