/* Each time its button is pressed, a lamp shines for 50 ms. */
#define MC_GPI 4
#define MC_GPO 12

int lamp(int number)
{
  int inputs;
  int bit;
  int pressed;

  bit = number - 1;
lbl_wait:
  GT_GetDi(MC_GPI, &inputs);
  inputs = inputs >> bit;
  pressed = inputs & 1;
  if (pressed) goto lbl_on;
  goto lbl_wait;
lbl_on:
  GT_SetDoBit(MC_GPO, number, 1);
  GT_Delay(50);
  GT_SetDoBit(MC_GPO, number, 0);
  goto lbl_wait;
}
