// As structured C this has a mistake, too: each error is reported.
int list[5], sum, i;
void t0() {
  for (i = 0; i < 5; i++) { // expect error MP102
    list[i] = i + 1;
  }
  while (i > 0) { // expect error MP101
    i--; // expect error MP107
    sum += list[i]; // expect error MP106
  }
  sum++; // expect error MP107
  unknown = 1; // expect error MP027
}
