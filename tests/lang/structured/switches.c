//@ structured
// Cases fall through, stand anywhere in the body, have ranges, and need no braces.
// expect: a=3, b=30, c=100, d=5, e=2, f=11, g=1
int a, b, c, d, e, f, g;
int classify(int value) {
  switch (value) {
    default: return 100;
    case -3 ... 3: return 30;
    case 7: return 5;
  }
}
void t0() {
  int i = 2;
  switch (i) {
    case 1: a += 10;
    case 2: a += 1;
    case 3: a += 2; break;
    case 4: a += 20;
  }
  b = classify(-3);
  c = classify(4);
  d = classify(7);
  switch (i + 1) case 3: e = 2;
  switch (i) {
    while (i < 5) {
      case 2: f += i; i++;
      if (i == 5) f += 2;
    }
  }
  for (i = 0; i < 4; i++) switch (i) { case 1: continue; case 2: g++; break; }
}
