//@ structured
// What the lowered text has of an element is not what the command takes.
struct axis {
  int number;
  TTrapPrm trap;
} axis[3];
void t0(int i) {
  GT_SetJogPrm(1, &axis[i].trap); // expect error MP019
}
