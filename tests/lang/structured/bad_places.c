//@ structured
int a;
a = 1; // expect error MP030
if (a) a = 2; // expect error MP030
here: // expect error MP030
} // expect error MP024
void t0() {
  if (a) int b; // expect error MP208
  else int c; // expect error MP208
  while (a) next: int d; // expect error MP208
  for (;;) { int e; }
  switch (a) case 1: int f; // expect error MP208
}
