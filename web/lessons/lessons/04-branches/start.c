/* Limits a speed to -most ... most. */
int limited(int speed, int most)
{
  int result;
  int cc;

  cc = speed > most;
  if (cc) goto lbl_too_fast;
  result = speed;
lbl_too_fast:
  result = most;
  return result;
}
