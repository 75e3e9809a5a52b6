/* Commands of GT400 motion controllers, for hosts that were written for ISA cards: GT_Open has the
   base address of the card and the number of its interrupt. Here both may be anything. In C++
   GT400.h has this function, too. */
#ifndef ONCARD_GTDLL_H_
#define ONCARD_GTDLL_H_

#include "GT400.h"

#ifndef __cplusplus
#define GT_Open(PortBase, irq) ((void)(PortBase), (void)(irq), GT_Open())
#endif

#endif
