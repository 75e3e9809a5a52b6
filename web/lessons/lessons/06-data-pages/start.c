/* Gives the largest of the eight measured values. */
int largest(void)
{
  int values[8];
  int i;
  int cc;
  int best;

  best = 0;
  i = 1;
lbl_loop:
  cc = i > 8;
  if (cc) goto lbl_end;
  cc = values[i] <= best;
  if (cc) goto lbl_next;
  best = values[i];
lbl_next:
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return best;
}
