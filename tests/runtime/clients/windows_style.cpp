// A host in the style of Windows programs: jogs an axis until the key q is pressed; the keys + and
// - change the velocity. It contains nothing specific to this project.
#include <Windows.h>
#include <conio.h>
#include <stdio.h>

#include "gts.h"

int main() {
  LARGE_INTEGER frequency, begin, end;
  TJogPrm jog;
  double velocity = 10, position = 0;
  int key = 0;

  if (GT_Open() != 0) {
    printf("no card\n");
    return 1;
  }
  GT_Reset();
  GT_ClrSts(1, 8);
  GT_AxisOn(1);
  GT_PrfJog(1);
  GT_GetJogPrm(1, &jog);
  jog.acc = 1;
  jog.dec = 1;
  GT_SetJogPrm(1, &jog);
  GT_SetVel(1, velocity);
  GT_Update(1 << 0);

  QueryPerformanceFrequency(&frequency);
  QueryPerformanceCounter(&begin);
  DWORD ticks = GetTickCount();
  while (key != 'q') {
    if (_kbhit()) {
      key = _getch();
      if (key == '+') velocity += 10;
      if (key == '-') velocity -= 10;
      GT_SetVel(1, velocity);
      GT_Update(1 << 0);
    }
    Sleep(10);
  }
  ticks = GetTickCount() - ticks;
  QueryPerformanceCounter(&end);
  GT_Stop(1, 0);
  Sleep(100);
  GT_GetPrfPos(1, &position);
  printf("%.0f pulses, %lu ms, %.2f s\n", position, ticks,
         (double)(end.QuadPart - begin.QuadPart) / (double)frequency.QuadPart);
  printf("press any key\n");
  getch();
  GT_Close();
  return 0;
}
