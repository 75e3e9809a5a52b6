int t0() {
  GT_SetDo(MC_GPO, 0x01); // expect error MP027
  GT_SetDo(MC_GPO, 0x02);
  return 0;
}
