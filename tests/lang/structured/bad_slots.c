//@ structured
// A page has 1024 slots for a function and all that it calls.
int v;
int pick(int i) {
  int values[600] = {0};
  return values[i];
}
void t0(int i) {  // expect error MP237
  int more[500] = {0};
  v = pick(i) + more[i];
}
