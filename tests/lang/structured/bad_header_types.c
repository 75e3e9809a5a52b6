//@ structured
int v;
int32_t a; // expect error MP114
uint8_t b, c; // expect error MP114
const int_least16_t d = 1; // expect error MP114
int64_t e; // expect error MP200
unsigned size_t f; // expect error MP114
int32_t g(uint_fast16_t x) { // expect error MP114 // expect error MP114
  uint32_t y = x; // expect error MP114
  return y + (int8_t)x; // expect error MP114
}
void t0() {
  v = L'x'; // expect error MP201
  v = u8'x'; // expect error MP201
}
