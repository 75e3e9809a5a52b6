/* A host that loads the library while it runs, and unloads it: what the library has replaced is put
   back. The argument is the name of the library. */
#include <stdio.h>
#include <windows.h>

#include "check.h"

typedef short(__stdcall* Open)(short channel, short parameter);
typedef short(__stdcall* Close)(void);

/* Where the program keeps the address of ExitProcess(). */
static void** FindImport(const void* function) {
  char* const base = (char*)GetModuleHandleA(NULL);
  const IMAGE_DOS_HEADER* const dos = (const IMAGE_DOS_HEADER*)base;
  const IMAGE_NT_HEADERS* const header = (const IMAGE_NT_HEADERS*)(base + dos->e_lfanew);
  const IMAGE_IMPORT_DESCRIPTOR* import =
      (const IMAGE_IMPORT_DESCRIPTOR*)(base + header->OptionalHeader
                                                  .DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT]
                                                  .VirtualAddress);
  for (; import->FirstThunk != 0; ++import) {
    for (void** slot = (void**)(base + import->FirstThunk); *slot != NULL; ++slot) {
      if (*slot == function) return slot;
    }
  }
  return NULL;
}

int main(int argc, char** argv) {
  const void* const original =
      (const void*)GetProcAddress(GetModuleHandleA("kernel32.dll"), "ExitProcess");
  void** const slot = FindImport(original);
  int run;
  if (argc == 0) ExitProcess(9); /* so that the program imports it */
  CHECK_EQ(slot != NULL, 1);
  for (run = 0; run < 2; ++run) {
    const HMODULE library = LoadLibraryA(argv[1]);
    CHECK_EQ(library != NULL, 1);
    CHECK_EQ(*slot != original, 1);
    ACCEPTED(((Open)(void*)GetProcAddress(library, "GT_Open"))(0, 1));
    if (run == 0) ACCEPTED(((Close)(void*)GetProcAddress(library, "GT_Close"))());
    CHECK_EQ(FreeLibrary(library), TRUE);
    CHECK_EQ(GetModuleHandleA(argv[1]) == NULL, 1);
    CHECK_EQ(*slot == original, 1);
  }
  printf("unloaded\n");
  return 0;
}
