#include "unclosed.h"
int t1() { return 0; }
