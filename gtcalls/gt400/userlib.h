/* Commands of GT400 motion controllers, for hosts that were written for DOS: GT400.h, and the word
   with which their compilers mark handlers of interrupts. */
#ifndef ONCARD_USERLIB_H_
#define ONCARD_USERLIB_H_

#include "GT400.h"

#define interrupt

#endif
