//@ structured
// A goto reaches every label of the function, as in C, into blocks too.
// expect: v=12, w=3
int v, w;
void t0() {
  int i = 0;
  goto inside;
  while (i < 4) {
    v += 100;
inside:
    v += 3;
    i++;
    if (i < 4) goto inside;
  }
again:
  if (++w < 3) goto again;
}
