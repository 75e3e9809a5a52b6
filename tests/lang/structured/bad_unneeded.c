//@ structured
// What a thread function calls is needed, also through others and with a prototype.
int v;
static int inner(int n);
static int outer(int n) { return inner(n); }
static int inner(int n) { return (int *)n; } // expect error MP203
static int unneeded(int n) { return (int *)n; } // expect warning MP219
int not_static(int **n) { return 0; } // expect error MP129
void t0(void) {
  v = outer(3);
}
