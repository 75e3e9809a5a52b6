// A host in the style of Windows programs: a move that has ended long before its sleep.
#include <windows.h>

#include <cstdio>

#include "gts.h"

int main() {
  if (GT_Open() != 0) return 1;
  GT_Reset();
  GT_ClrSts(1, 8);
  GT_AxisOn(1);
  GT_PrfTrap(1);
  TTrapPrm trap = {1, 1, 0, 0};
  GT_SetTrapPrm(1, &trap);
  GT_SetPos(1, 5000);
  GT_SetVel(1, 50);
  GT_Update(1);
  const DWORD begin = GetTickCount();
  Sleep(60000);
  double position = 0;
  GT_GetPrfPos(1, &position);
  std::printf("%.0f pulses, %lu ms\n", position, GetTickCount() - begin);
  GT_Close();
}
