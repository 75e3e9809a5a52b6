/* Gives the nearest number of pulses: 1000 pulses are 1 mm. */
int pulses(double mm)
{
  int whole;
  int result;

  whole = (int) mm;
  result = whole * 1000;
  return result;
}
