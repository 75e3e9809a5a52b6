#include <stdio.h> // expect error MP037
#include "" // expect error MP037
#include // expect error MP037
int t0() { return 0; }
