#include "tools/host_program.h"

#include <elf.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string_view>
#include <system_error>

namespace oncard::tools {
namespace {

bool IsExecutable(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

/// The file to which a program name refers; empty if there is none.
std::string FindProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) return IsExecutable(name) ? name : "";
  const char* const list = std::getenv("PATH");
  std::string_view folders = list != nullptr ? list : "/bin:/usr/bin";
  while (true) {
    const size_t end = folders.find(':');
    const std::string_view folder = folders.substr(0, end);
    std::string path = std::string(folder.empty() ? "." : folder) + '/' + name;
    if (IsExecutable(path)) return path;
    if (end == std::string_view::npos) return {};
    folders.remove_prefix(end + 1);
  }
}

std::filesystem::path FolderOfCommand() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

/// The first of the folders that holds the file; empty if none does.
std::string FolderWith(const char* file, std::initializer_list<std::filesystem::path> folders) {
  std::error_code ignored;
  for (const auto& folder : folders) {
    if (std::filesystem::exists(folder / file, ignored)) return folder.string();
  }
  return {};
}

}  // namespace

LibraryFolders FindLibraries() {
  const auto beside = FolderOfCommand();
  const auto above = beside.parent_path();
  const auto lib = above / "lib";
  return {FolderWith(kPreloadLibrary,
                     {beside, lib, lib / ONCARD_LIBRARY_ARCHITECTURE / "oncard", lib / "oncard"}),
          FolderWith(kPreloadLibrary, {above / "lib32", above / "lib32/oncard"})};
}

HeaderFolders FindHeaders() {
  const auto include = FolderOfCommand().parent_path() / "include";
  return {FolderWith("gts.h", {include}),
          FolderWith("windows.h", {include / "compat", include / "oncard" / "compat"})};
}

bool IsProgramOf32Bits(const std::string& name) {
  std::array<char, EI_NIDENT> begin{};
  std::ifstream file(FindProgram(name), std::ios::binary);
  return file.read(begin.data(), begin.size()) && std::memcmp(begin.data(), ELFMAG, SELFMAG) == 0 &&
         begin[EI_CLASS] == ELFCLASS32;
}

}  // namespace oncard::tools
