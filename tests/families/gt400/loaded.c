/* A host that loads the library by the name that it has on Windows: its argument. */
#include <dlfcn.h>
#include <stdio.h>
#include <unistd.h>

int main(int argc, char** argv) {
  void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  short (*open_cards)(void);
  short (*get_clock)(unsigned long*);
  unsigned long clock = 0;
  if (library == NULL) return 1;
  *(void**)&open_cards = dlsym(library, "GT_Open");
  *(void**)&get_clock = dlsym(library, "GT_GetClock");
  if (open_cards() != 0) return 2;
  sleep(1);
  get_clock(&clock);
  printf("clock %lu\n", clock);
  return 0;
}
