int i, j;
int t0() {
  i = &j; // expect error MP028
  i = *j; // expect error MP028
  i = +j; // expect error MP028
  i = i ? 1 : 2; // expect error MP028
  i = "text"; // expect error MP127
  i = 'a'; // expect error MP127
  i = sizeof(i); // expect error MP115
  return 0;
}
