/* switch with a comparison and a jump for each case (GTS manual 10.4.3). The constants of the C
   header do not exist in motion programs: define those that you use. */
#define MC_GPO 12

int choose(int a)
{
  int cc;

  cc = a == 1;
  if (cc) goto lbl_1;
  cc = a == 2;
  if (cc) goto lbl_2;
  cc = a == 5;
  if (cc) goto lbl_5;
  goto lbl_end;
lbl_1:
  GT_SetDo(MC_GPO, 0x01);
  goto lbl_end;
lbl_2:
  GT_SetDo(MC_GPO, 0x02);
  goto lbl_end;
lbl_5:
  GT_SetDo(MC_GPO, 0x04);
  goto lbl_end;
lbl_end:
  return 0;
}
