//@ structured
// Loops, with break and continue, nested and without braces.
// expect: v=10, w=6, x=3, y=25, z=7, n=3
int v, w, x, y, z, n;
void t0() {
  int i;
  for (i = 0; i < 5; i++) v += i;
  while (w < 10) {
    w++;
    if (w == 6) break;
  }
  do x++; while (x < 3);
  for (int a = 0; a < 10; a++) {
    if (a % 2 == 0) continue;
    y += a;
  }
  for (;;) {
    if (++z > 6) break;
  }
  for (int a = 0; a < 3; a++)
    for (int b = 0; b < 3; b++)
      if (b > a) break; else if (b == a) n++;
}
