//@ structured
char text[] = "text"; // expect error MP202
void t0() {
  int a;
  a = "x"[0]; // expect error MP202
  print("a \"quoted\" word", a); // expect error MP202
}
