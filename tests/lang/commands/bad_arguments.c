long a, arr[4], clock;
double d;
TTrapPrm trap;
TJogPrm jog;
int t0() {
  int i;
  GT_GetClock(&a); // expect error MP043
  GT_Update(); // expect error MP043
  GT_Update(1, 2); // expect error MP050
  GT_GetClock(a, &clock); // expect error MP044
  GT_GetClock(&a, NULL); // expect error MP044
  GT_GetClock(&a, 0); // expect error MP044
  GT_Update(&a); // expect error MP028
  GT_SetVel(1, i); // expect error MP019
  GT_SetPos(1, d); // expect error MP019
  GT_SetPos(1, 2.5); // expect error MP019
  GT_GetPos(1, &d); // expect error MP019
  GT_GetVel(1, &a); // expect error MP019
  GT_SetTrapPrm(1, &jog); // expect error MP019
  GT_SetTrapPrm(1, trap); // expect error MP044
  GT_SetTrapPrm(1, &a); // expect error MP019
  GT_GetSts(1, &arr, 4, &clock); // expect error MP048
  GT_GetSts(1, &arr[1], 4, &clock); // expect error MP121
  GT_GetSts(1, &a, 2, &clock); // expect error MP121
  GT_GetSts(1, &a, 1, &missing); // expect error MP027
  GT_SetPos(1, i + 1); // expect error MP100
  return 0;
}
