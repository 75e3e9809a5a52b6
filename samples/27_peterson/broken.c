/* Peterson's lock with two lines exchanged: each thread first gives the turn to the other one, and
   only then sets its flag. Both can hold the lock. */
int want0;
int want1;
int turn;
int inside;
int count;

int first()
{
  int wait;
  int theirs;

  turn = 1;
  want0 = 1;
lbl_wait:
  theirs = turn == 1;
  wait = want1;
  wait = wait && theirs;
  if (wait) goto lbl_wait;
  inside = inside + 1;
  count = count + 1;
  inside = inside - 1;
  want0 = 0;
  return 0;
}

int second()
{
  int wait;
  int theirs;

  turn = 0;
  want1 = 1;
lbl_wait:
  theirs = turn == 0;
  wait = want0;
  wait = wait && theirs;
  if (wait) goto lbl_wait;
  inside = inside + 1;
  count = count + 1;
  inside = inside - 1;
  want1 = 0;
  return 0;
}
