/* GT commands with `short cardNum` in front of the other parameters, for up to 16 cards. */
#ifndef ONCARD_GTS_MULTI_H_
#define ONCARD_GTS_MULTI_H_

#define GTS_MULTI_CARD
#include "gts.h"

#endif
