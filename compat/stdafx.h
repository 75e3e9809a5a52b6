/* What Visual Studio writes into the stdafx.h of a console project, for hosts that come without
   their own; and windows.h, without which the vendor's gts.h cannot be read. */
#ifndef ONCARD_COMPAT_STDAFX_H_
#define ONCARD_COMPAT_STDAFX_H_

#include <stdio.h>

#include "tchar.h"
#include "windows.h"

#endif
