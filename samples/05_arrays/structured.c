//@ structured
/* largest.c as C has it, and a table with two dimensions. Values in braces are written before any
   thread passes its first statement. */
#define COUNT 8
#define ROWS 2

int value[COUNT] = {3, -6, 4, 1, 5, 9, 2, 9};
int table[ROWS][COUNT / 2] = {{1, 2, 3}, {10, 20, 30, 40}};

/* Index of the largest element, the first one if there are several. */
int largest(void)
{
  int best = 0;

  for (int i = 1; i < COUNT; i++)
    if (value[i] > value[best]) best = i;
  return best;
}

/* The sum of one row. An index of a row that does not exist is a fault, or reads another element:
   check what comes from outside. */
int sum_of_row(int row)
{
  int sum = 0;

  if (row < 0 || row >= ROWS) return -1;
  for (int column = 0; column < COUNT / 2; column++) sum += table[row][column];
  return sum;
}
