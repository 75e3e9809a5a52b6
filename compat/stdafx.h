/* The contents of stdafx.h in a console project of Visual Studio, for hosts without their own file;
   and windows.h, which the vendor's gts.h needs. */
#ifndef ONCARD_COMPAT_STDAFX_H_
#define ONCARD_COMPAT_STDAFX_H_

#include <stdio.h>

#include "tchar.h"
#include "windows.h"

#endif
