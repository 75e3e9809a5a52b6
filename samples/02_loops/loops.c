/* Loops are written with labels and goto (GTS manual 10.4.3). A condition is a variable, so the
   comparison is a statement of its own. */

/* while (i <= 10) { sum = sum + i; i = i + 1; } */
int test_first(void)
{
  int i;
  int sum;
  int cc;

  i = 1;
  sum = 0;
lbl_loop:
  cc = i > 10;
  if (cc) goto lbl_end;
  sum = sum + i;
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return sum;
}

/* do { sum = sum + i; i = i + 1; } while (i <= 10); one statement less in each iteration */
int test_last(void)
{
  int i;
  int sum;
  int cc;

  i = 1;
  sum = 0;
lbl_loop:
  sum = sum + i;
  i = i + 1;
  cc = i <= 10;
  if (cc) goto lbl_loop;
  return sum;
}

/* for (i = 10; i > 0; i = i - 2) sum = sum + i; */
int count_down(void)
{
  int i;
  int sum;
  int cc;

  sum = 0;
  i = 10;
lbl_loop:
  cc = i <= 0;
  if (cc) goto lbl_end;
  sum = sum + i;
  i = i - 2;
  goto lbl_loop;
lbl_end:
  return sum;
}
