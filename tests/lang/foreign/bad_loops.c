int i, s;
int t0() {
  while (i < 10) { // expect error MP101
    s = s + i;
    i = i + 1;
  }
  for (i = 0; i < 10; i++) { // expect error MP102
    s = s + i;
    if (s > 100) break; // expect error MP045
  }
  do { // expect error MP103
    i = i - 1;
  } while (i);
  do i = 1; until (i); // expect error MP131
  break; // expect error MP115
  continue; // expect error MP115
  return 0;
}
