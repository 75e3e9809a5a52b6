#include "tools/filter.h"

#include "tools/child_windows.h"

namespace oncard::tools {

std::optional<FilterRun> RunFilter(const std::vector<std::string>& words, const std::string& text) {
  const SystemHandle in = ScratchFile();
  const SystemHandle out = ScratchFile();
  const SystemHandle err = ScratchFile();
  DWORD written = 0;
  if (!in.valid() || !out.valid() || !err.valid() ||
      ::WriteFile(in.get(), text.data(), static_cast<DWORD>(text.size()), &written, nullptr) == 0) {
    return std::nullopt;
  }
  ::SetFilePointer(in.get(), 0, nullptr, FILE_BEGIN);
  const auto process =
      StartChild({}, CommandLineOf(words), {.in = in.get(), .out = out.get(), .err = err.get()});
  if (!process.ok()) return std::nullopt;
  ::WaitForSingleObject(process.value().get(), INFINITE);
  DWORD code = 0;
  ::GetExitCodeProcess(process.value().get(), &code);
  return FilterRun{ContentOf(out), ContentOf(err), code == 0};
}

}  // namespace oncard::tools
