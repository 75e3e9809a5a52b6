//@ structured
/* switch.c as C has it, with a range of cases and a default, which must not come last. */
#define MC_GPO 12

int choose(int a)
{
  switch (a) {
    default:
      return -1;
    case 1:
      GT_SetDo(MC_GPO, 0x01);
      break;
    case 2:
      GT_SetDo(MC_GPO, 0x02);
      break;
    case 5 ... 7:
      GT_SetDo(MC_GPO, 0x04);
  }
  return 0;
}
