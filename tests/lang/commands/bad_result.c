int rtn;
int t0() {
  rtn = GT_Update(1); // expect error MP049
  rtn = GT_Update(1) + 2; // expect error MP049
  return rtn;
}
