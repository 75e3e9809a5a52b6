#include "path.c"
