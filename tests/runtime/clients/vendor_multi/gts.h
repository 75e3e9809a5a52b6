#pragma once

// A few lines in the style of the vendor's header for several cards: the functions have the same
// names as for one card, and the card number as an additional first parameter.
#define GT_API extern "C" short __stdcall

GT_API GT_Open(short cardNum, short channel = 0, short param = 1);
GT_API GT_Reset(short cardNum);
GT_API GT_LoadConfig(short cardNum, char* pFile);
GT_API GT_ClrSts(short cardNum, short axis, short count = 1);
GT_API GT_AxisOn(short cardNum, short axis);
GT_API GT_GetClock(short cardNum, unsigned long* pClock, unsigned long* pLoop = NULL);
