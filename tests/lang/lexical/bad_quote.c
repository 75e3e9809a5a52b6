#include "missing.h
int t0() { return 0; } // expect error MP036 @1
