// Structured C without its first line: one error instead of one for each construct.
int list[5], sum, i;
int twice(int x) { return x * 2 + 1; } // expect error MP140
void t0() {
  for (i = 0; i < 5; i++) {
    list[i] = twice(i) + 1;
  }
  while (i > 0) {
    i--;
    sum += list[i];
  }
}
