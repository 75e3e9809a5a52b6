int a, b, arr[2];
double d;
#define YES 1
int t0() {
  if (a > b) goto l; // expect error MP109
  if (!a) goto l; // expect error MP109
  if (1) goto l; // expect error MP109
  if (YES) goto l; // expect error MP109
  if (d) goto l; // expect error MP109
  if (arr[0]) goto l; // expect error MP109
  if (GT_Update(1)) goto l; // expect error MP109
  if (a) return b + 1; // expect error MP100
l:
  return 0;
}
