/* Peterson's lock: a thread that wants to enter sets its flag, gives the turn to the other one, and
   waits while the other one has its flag set and has the turn. */
int want0;
int want1;
int turn;
int inside;
int count;

int first()
{
  int wait;
  int theirs;

  want0 = 1;
  turn = 1;
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

  want1 = 1;
  turn = 0;
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
