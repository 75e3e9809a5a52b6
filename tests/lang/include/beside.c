#include "constants.h"
int t0() {
  shared = LIMIT;
  return 0; // expect: shared=12
}
