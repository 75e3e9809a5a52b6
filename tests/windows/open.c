/* A host that opens a card, and ends with the code that GT_Open returns, without its sign. An
   argument that is a number is the exit code instead; any other is a program that it runs
   meanwhile. */
#include <process.h>
#include <stdlib.h>

#include "gts.h"

int main(int argc, char** argv) {
  const short code = GT_Open(0, 1);
  if (code != 0 || argc < 2) return -code;
  if (atoi(argv[1]) != 0) return atoi(argv[1]);
  return _spawnl(_P_WAIT, argv[1], argv[1], (char*)0) == 6 ? 0 : 1;
}
