/* Outputs, time and inputs. */
#define MC_GPI 4
#define MC_GPO 12
#define LAMP 1
#define ON 1
#define OFF 0

/* Switches the lamp on and off, 10 ms each. During a delay the other threads get more time. */
int blink(int times)
{
  int i;
  int cc;

  i = 0;
lbl_loop:
  cc = i >= times;
  if (cc) goto lbl_end;
  GT_SetDoBit(MC_GPO, LAMP, ON);
  GT_Delay(10);
  GT_SetDoBit(MC_GPO, LAMP, OFF);
  GT_Delay(10);
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return i;
}

/* The lamp follows the first general-purpose input, for ever. */
int follow(void)
{
  int inputs;
  int level;

lbl_loop:
  GT_GetDi(MC_GPI, &inputs);
  level = inputs & 1;
  GT_SetDoBit(MC_GPO, LAMP, level);
  goto lbl_loop;
}
