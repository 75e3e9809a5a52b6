// Replaces functions that the program and its modules import, by writing into their tables of
// imports. Windows itself is left alone: only the modules outside of its folder are changed, and
// the libraries of programming languages in it, such as msvcrt.dll.
//
// Thread-safe. Tested by tests/windows/.
#pragma once

#include <windows.h>

#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace oncard::runtime {

struct Replacement {
  /// A function of the same type as the one that has the name.
  template <typename Function>
  Replacement(const char* replaced, Function* by)
      : name(replaced), function(reinterpret_cast<void*>(by)) {}

  const char* name;
  void* function;
};

class ImportPatches {
 public:
  ImportPatches() = default;
  ImportPatches(const ImportPatches&) = delete;
  ImportPatches& operator=(const ImportPatches&) = delete;

  /// The process's own; never destroyed.
  static ImportPatches& OfProcess();

  /// Replaces these functions, too, from the next PatchModules() on.
  void Add(std::span<const Replacement> replacements);
  /// Changes the imports of all modules that are loaded.
  void PatchModules();
  /// Puts all imports back.
  void PutBack();

  /// What replaces a function; the function itself if nothing does.
  FARPROC ReplacementOf(FARPROC function);

 private:
  struct Patched {
    void** slot;
    void* original;
    void* function;
  };

  /// The functions that are to be replaced, with what replaces them.
  std::map<void*, void*> FindOriginals();
  void PatchModule(HMODULE module);
  void PatchSlots(void** slot);

  std::mutex mutex_;  // guards what follows
  std::vector<Replacement> replacements_;
  std::map<void*, void*> replacement_of_;  ///< of an original
  std::vector<Patched> patched_;
};

}  // namespace oncard::runtime
