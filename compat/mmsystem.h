/* timeGetTime() and its kin: windows.h has them. */
#include "windows.h"
