/* Gives the nearest number of pulses: 1000 pulses are 1 mm. */
int pulses(double mm)
{
  double exact;
  int result;

  exact = mm * 1000;
  exact = exact + 0.5;
  result = (int) exact;
  return result;
}
