#include "in_folder.h"
int v;
int t0() {
  v = FROM_FOLDER;
  return 0; // expect: v=5
}
