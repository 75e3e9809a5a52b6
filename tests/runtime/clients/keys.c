/* Hosts that wait for keys; the argument selects one. */
#include <conio.h>
#include <stdio.h>
#include <string.h>
#include <windows.h>

#include "gts.h"

int main(int argc, char** argv) {
  int looks = 0;
  int key = 0;

  if (argc != 2) return 2;
  if (strcmp(argv[1], "until_hit") == 0) {
    for (looks = 0; looks < 100; ++looks) {
      if (kbhit()) printf("%c\n", getch());
      Sleep(1);
    }
    printf("%d looks\n", looks);
  }
  if (strcmp(argv[1], "last") == 0) {
    printf("press any key\n");
    getch();
  }
  if (strcmp(argv[1], "until_q") == 0) {
    printf("begins\n");
    while (key != 'q') {
      key = getch();
      if (key >= 0) printf("%c\n", key);
    }
  }
  return 0;
}
