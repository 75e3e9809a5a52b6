/* Limits a speed to -most ... most. */
int limited(int speed, int most)
{
  int result;
  int least;
  int cc;

  least = 0 - most;
  cc = speed > most;
  if (cc) goto lbl_too_fast;
  cc = speed < least;
  if (cc) goto lbl_too_fast_back;
  result = speed;
  goto lbl_end;
lbl_too_fast:
  result = most;
  goto lbl_end;
lbl_too_fast_back:
  result = least;
lbl_end:
  return result;
}
