int t0() {
#include "constants.h" // expect error MP023
  return 0;
}
