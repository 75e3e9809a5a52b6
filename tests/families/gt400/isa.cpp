// isa.c in C++, where GT_Open is overloaded.
#include "isa.c"
