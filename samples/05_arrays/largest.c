/* Arrays have one dimension. An index is a literal, a macro or an int variable. */
#define COUNT 8

int value[COUNT];

/* Index of the largest element, the first one if there are several. */
int largest(void)
{
  int i;
  int best;
  int cc;

  best = 0;
  i = 1;
lbl_loop:
  cc = i >= COUNT;
  if (cc) goto lbl_end;
  cc = value[i] > value[best];
  if (cc) goto lbl_better;
  goto lbl_next;
lbl_better:
  best = i;
lbl_next:
  i = i + 1;
  goto lbl_loop;
lbl_end:
  return best;
}

/* Reads one element; an index outside 0..7 is a fault that stops the thread. */
int pick(int i)
{
  int v;

  v = value[i];
  return v;
}
