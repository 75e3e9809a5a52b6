#define EMPTY // expect error MP035
#define SUM 1 + 2 // expect error MP035
#define CALL(x) 3 // expect error MP035
#define UNKNOWN OTHER // expect error MP035
#define 5 6 // expect error MP128
#define WORD int // expect error MP035
int t0() {
  return EMPTY;
}
