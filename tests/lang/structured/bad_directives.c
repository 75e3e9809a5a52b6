//@ structured
#redefine N 1 // expect error MP217
#line 100 // expect error MP217
#error the axes are wrong // expect error MP216
#if 1 / 0 // expect error MP215
#endif
#endif // expect error MP214
#if 1 // expect error MP214
#include "self.h" // expect error MP212
