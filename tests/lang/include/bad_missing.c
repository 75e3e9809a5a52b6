#include "nowhere.h" // expect error MP022
int t0() { return 0; }
