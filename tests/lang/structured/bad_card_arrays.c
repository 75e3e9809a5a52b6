//@ structured
// Elements that are structures of the card where they do not fit.
struct axis {
  int number;
  TTrapPrm trap;
} axis[3];
TTrapPrm traps[2];
TJogPrm jog;
const TTrapPrm presets[2] = {{1, 2}};
struct many { TPid pid[129]; } many; // expect error MP016
int n;
static void set(TTrapPrm *t) { t->acc = 1; } // expect error MP233
static int at(TTrapPrm *t, int i) { return t[i].acc; }
void t0(int i) {
  GT_SetTrapPrm(1, &axis[i]); // expect error MP031
  GT_SetTrapPrm(1, axis); // expect error MP031
  GT_SetTrapPrm(1, traps[i]); // expect error MP031
  GT_SetTrapPrm(1, &presets[i]); // expect error MP233
  GT_SetTrapPrm(1, &traps[2]); // expect error MP017
  set(&axis[i]); // expect error MP244
  set(&jog); // expect error MP244
  set(presets);
  axis[i].trap = jog; // expect error MP019
  axis[i].trap.speed = 1; // expect error MP029
  n = traps[i]; // expect error MP031
  n = at(&axis[i].trap, i);
}
