#include "runtime/host/import_patches_windows.h"

#include <tlhelp32.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace oncard::runtime {
namespace {

/// The libraries that have the functions. The same function has another address in each.
constexpr const char* kProviders[] = {
    "kernel32.dll", "kernelbase.dll", "ntdll.dll",    "winmm.dll",     "user32.dll",
    "msvcrt.dll",   "ucrtbase.dll",   "msvcr71.dll",  "msvcr80.dll",   "msvcr90.dll",
    "msvcr100.dll", "msvcr110.dll",   "msvcr120.dll", "ucrtbased.dll",
};

/// How the names of libraries of programming languages begin, which may be in the folder of
/// Windows.
constexpr std::string_view kLanguages[] = {"clr",    "concrt", "mfc",     "mscoree",
                                           "msvbvm", "msvc",   "ucrtbas", "vcruntime"};

std::string Lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return text;
}

bool IsOfWindows(const std::string& path) {
  std::array<char, MAX_PATH> folder{};
  ::GetWindowsDirectoryA(folder.data(), folder.size());
  return Lower(path).starts_with(Lower(folder.data()) + "\\");
}

/// True for a module that shall use the replacements.
bool IsPatched(const MODULEENTRY32& module) {
  if (!IsOfWindows(module.szExePath)) return true;
  const std::string name = Lower(module.szModule);
  return std::ranges::any_of(kLanguages,
                             [&](std::string_view language) { return name.starts_with(language); });
}

HMODULE OwnModule() {
  HMODULE own = nullptr;
  ::GetModuleHandleExA(
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
      reinterpret_cast<const char*>(&kProviders), &own);
  return own;
}

std::vector<HMODULE> ModulesToPatch() {
  std::vector<HMODULE> modules;
  const HANDLE list = ::CreateToolhelp32Snapshot(TH32CS_SNAPMODULE, 0);
  if (list == INVALID_HANDLE_VALUE) return modules;
  MODULEENTRY32 module{};
  module.dwSize = sizeof module;
  for (BOOL more = ::Module32First(list, &module); more != 0;
       more = ::Module32Next(list, &module)) {
    if (module.hModule != OwnModule() && IsPatched(module)) modules.push_back(module.hModule);
  }
  ::CloseHandle(list);
  return modules;
}

void Write(void** slot, void* value) {
  DWORD before = 0;
  if (::VirtualProtect(static_cast<void*>(slot), sizeof *slot, PAGE_READWRITE, &before) == 0) {
    return;
  }
  *slot = value;
  ::VirtualProtect(static_cast<void*>(slot), sizeof *slot, before, &before);
}

/// False if the module of a slot has been unloaded.
bool IsThere(void** slot) {
  MEMORY_BASIC_INFORMATION memory{};
  return ::VirtualQuery(static_cast<void*>(slot), &memory, sizeof memory) != 0 &&
         memory.State == MEM_COMMIT && (memory.Protect & (PAGE_NOACCESS | PAGE_GUARD)) == 0;
}

template <typename T>
T* At(HMODULE module, DWORD offset) {
  return reinterpret_cast<T*>(reinterpret_cast<char*>(module) + offset);
}

}  // namespace

ImportPatches& ImportPatches::OfProcess() {
  // Never destroyed: other threads of the host may still call the functions while the process
  // exits.
  static ImportPatches& patches = *new ImportPatches;
  return patches;
}

void ImportPatches::Add(std::span<const Replacement> replacements) {
  const std::lock_guard lock(mutex_);
  replacements_.insert(replacements_.end(), replacements.begin(), replacements.end());
}

// Windows is asked without the lock: what it says needs its lock of the loader, and a thread that
// has that one, because a DLL is told of it, may ask for a replacement.
void ImportPatches::PatchModules() {
  const std::vector<HMODULE> modules = ModulesToPatch();
  const std::map<void*, void*> found = FindOriginals();
  const std::lock_guard lock(mutex_);
  replacement_of_.insert(found.begin(), found.end());
  for (const HMODULE module : modules) PatchModule(module);
}

void ImportPatches::PutBack() {
  const std::lock_guard lock(mutex_);
  for (const Patched& patched : patched_) {
    if (IsThere(patched.slot) && *patched.slot == patched.function) {
      Write(patched.slot, patched.original);
    }
  }
  patched_.clear();
}

FARPROC ImportPatches::ReplacementOf(FARPROC function) {
  const std::lock_guard lock(mutex_);
  const auto found = replacement_of_.find(reinterpret_cast<void*>(function));
  return found == replacement_of_.end() ? function : reinterpret_cast<FARPROC>(found->second);
}

// Libraries that have been loaded since may have the functions, too.
std::map<void*, void*> ImportPatches::FindOriginals() {
  std::unique_lock lock(mutex_);
  const std::vector<Replacement> replacements = replacements_;
  lock.unlock();
  std::map<void*, void*> found;
  for (const char* const provider : kProviders) {
    const HMODULE library = ::GetModuleHandleA(provider);
    if (library == nullptr) continue;
    for (const Replacement& replacement : replacements) {
      void* const original = reinterpret_cast<void*>(::GetProcAddress(library, replacement.name));
      if (original != nullptr) found.emplace(original, replacement.function);
    }
  }
  return found;
}

void ImportPatches::PatchModule(HMODULE module) {
  const auto* const dos = At<IMAGE_DOS_HEADER>(module, 0);
  if (dos->e_magic != IMAGE_DOS_SIGNATURE) return;
  const auto* const header = At<IMAGE_NT_HEADERS>(module, static_cast<DWORD>(dos->e_lfanew));
  if (header->Signature != IMAGE_NT_SIGNATURE) return;
  const IMAGE_DATA_DIRECTORY& imports =
      header->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT];
  if (imports.VirtualAddress == 0) return;
  const auto* library = At<IMAGE_IMPORT_DESCRIPTOR>(module, imports.VirtualAddress);
  for (; library->FirstThunk != 0; ++library) PatchSlots(At<void*>(module, library->FirstThunk));
}

void ImportPatches::PatchSlots(void** slot) {
  for (; *slot != nullptr; ++slot) {
    const auto found = replacement_of_.find(*slot);
    if (found == replacement_of_.end()) continue;
    patched_.push_back({slot, found->first, found->second});
    Write(slot, found->second);
  }
}

}  // namespace oncard::runtime
