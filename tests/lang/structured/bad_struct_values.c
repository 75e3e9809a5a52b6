//@ structured
// What is the value of an expression cannot be changed, and a function is no value.
struct pair {
  int x;
  int list[2];
} a, b, c;
int n;
TTrapPrm trap;
static struct pair make(struct pair from) { return from; }
static TTrapPrm copy(TTrapPrm from) { return from; }
static void clear(struct pair *p) { p->x = 0; }
void t0(int i) {
  make(a) = b; // expect error MP031
  (i ? a : b) = c; // expect error MP031
  (a = b) = c; // expect error MP031
  (i, a) = b; // expect error MP031
  make(a).x = 1; // expect error MP031
  (i ? a : b).x += 3; // expect error MP031
  (a = b).x++; // expect error MP031
  clear(&(a = b)); // expect error MP031
  clear(&(i, a)); // expect error MP031
  GT_GetTrapPrm(1, &copy(trap)); // expect error MP031
  a = make; // expect error MP031
  b = i ? make : a; // expect error MP031
  n = make.x; // expect error MP031
  n = make(a).x + (i ? a : b).list[1] + (a = b).x + (i, a).x;
}
