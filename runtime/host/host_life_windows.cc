// The life of a host on Windows beside its calls: the library is told when it is loaded and when it
// is unloaded, and replaces functions in between.
#include <windows.h>

#include <cstdlib>

#include "runtime/host/call_scope.h"
#include "runtime/host/host_end_windows.h"
#include "runtime/host/host_imports_windows.h"
#include "runtime/host/host_threads_windows.h"
#include "runtime/host/host_time.h"

namespace oncard::runtime {
namespace {

/// The cards of the family interrupt their host (cmake/OncardFamilies.cmake).
constexpr bool kInterrupts = ONCARD_INTERRUPTS;

bool IsSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// The library stays until the end of the process: if it is unloaded now, it cannot judge its host,
/// or threads may still be in functions that it has replaced.
void Stay(HINSTANCE own) {
  HMODULE pinned = nullptr;
  ::GetModuleHandleExA(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_PIN,
                       reinterpret_cast<const char*>(own), &pinned);
}

void Begin(HINSTANCE own) {
  EnrolThread();
  ImportPatches& patches = ImportPatches::OfProcess();
  patches.Add(ProcessImports());
  const bool is_virtual = HostTimeIsVirtual();
  const bool has_keys = is_virtual || IsSet("ONCARD_KEYS") || IsSet("ONCARD_SCENARIO");
  if (has_keys) patches.Add(KeyImports());
  const bool has_waits = is_virtual || kInterrupts;
  if (has_waits) {
    for (const auto replacements : {WaitImports(), LoaderImports()}) patches.Add(replacements);
  }
  if (is_virtual) {
    for (const auto replacements : {ClockImports(), LockImports()}) patches.Add(replacements);
  }
  if (has_keys || has_waits || IsSet("ONCARD_REFUSALS")) Stay(own);
  patches.PatchModules();
}

/// The library is unloaded.
void Leave() {
  ImportPatches::OfProcess().PutBack();
  const CallScope scope;
  FinishOnce();
}

}  // namespace
}  // namespace oncard::runtime

/// `reserved` is not null where the process ends.
extern "C" BOOL WINAPI DllMain(HINSTANCE own, DWORD reason, void* reserved) {
  if (reason == DLL_PROCESS_ATTACH) oncard::runtime::Begin(own);
  if (reason == DLL_PROCESS_DETACH) {
    if (reserved == nullptr) {
      oncard::runtime::Leave();
    } else {
      oncard::runtime::FinishOnce();
    }
  }
  return TRUE;
}
