/* A host that opens no card. Its argument is its exit code. */
#include <stdlib.h>

#include "gts.h"

int main(int argc, char** argv) {
  short selected = 0;
  if (argc != 2 || GT_GetCardNo(&selected) != 0) return 2;
  return atoi(argv[1]);
}
