//@ structured
// What a thread function cannot be given, values that the card has no form for, and too many slots.
int v;
int twice(int a) { return a * 2; }
void t0(int list[]) {  // expect error MP245
  v = twice;  // expect error MP236
}
