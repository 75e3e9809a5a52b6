#include "nests.h"
int t0() { return 0; }
