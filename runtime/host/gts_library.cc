// libgts: the services of the host library for GTS cards. Tested by tests/runtime/host_api_test.cc
// and host_programs_test.cc.
#include <algorithm>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/path_bytes.h"
#include "compiler/compiler.h"
#include "gtcalls/gts/family.h"
#include "gts.h"
#include "runtime/host/card_number_hint.h"
#include "runtime/host/library.h"
#include "vm/object_writer.h"

namespace oncard::runtime {
namespace {

// Return codes (GTS manual table 3-1; GT_Download and GT_GetFunId in chapter 13).
constexpr int16_t kFileNotFound = 2007;
constexpr int16_t kNameNotFound = 2008;

/// Versions and dates of both firmwares, in the layout of GTS manual table 11-3. Assumption: the
/// number of this project's release and a fixed date are used for both.
constexpr std::string_view kFirmwareVersion = "010260101010260101";
static_assert(kFirmwareVersion.size() == 18);

/// Bytes of a network adapter's address.
constexpr size_t kMacAddressLength = 6;

/// Sizes of the buffers that TCompileInfo points to, including the terminating NUL. Assumption: the
/// manual gives none; its file names have at most 125 characters.
constexpr size_t kCompileFileNameSize = 128;
constexpr size_t kCompileMessageSize = 128;

// --- The card itself -----------------------------------------------------------------------------

/// Each call gives a block of its own: a .NET host frees what it is given.
int16_t GetVersion(ServiceCall& call) {
  auto* const text = static_cast<char*>(std::malloc(kFirmwareVersion.size() + 1));
  if (text == nullptr) return call.Refuse(vm::kRefused, {"no memory is left", "内存不足"});
  *std::copy(kFirmwareVersion.begin(), kFirmwareVersion.end(), text) = '\0';
  *static_cast<char**>(call.arguments[0].host) = text;
  return vm::kOk;
}

/// Assumption: there is no network adapter; each card has a locally administered address that ends
/// with its number, so that hosts that distinguish cards by address continue to work.
int16_t GetMacAddress(ServiceCall& call) {
  const std::span<double> address = call.arguments[1].cells;
  if (address.size() < kMacAddressLength) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("parameter ulAddressSize is {}; at least {} is needed",
                    "参数 ulAddressSize 为 {}；至少应为 {}", address.size(), kMacAddressLength));
  }
  constexpr double kLocallyAdministered = 0x02;
  address[0] = kLocallyAdministered;
  address[kMacAddressLength - 1] = call.card();
  return vm::kOk;
}

int16_t GetCardNo(ServiceCall& call) {
  call.arguments[0].cells[0] = call.table.selected;
  return vm::kOk;
}

// --- Program files -------------------------------------------------------------------------------

/// Copies a text into a buffer of the host, which may be NULL; a text that is too long is cut
/// between two characters.
void CopyText(std::string_view text, size_t size, char* buffer) {
  if (buffer == nullptr) return;
  size_t length = std::min(text.size(), size - 1);
  if (length < text.size()) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (length > 0 && continues(text[length])) --length;
  }
  std::copy_n(text.data(), length, buffer);
  buffer[length] = '\0';
}

void FillCompileInfo(TCompileInfo* info, std::string_view file, int line, std::string_view text) {
  CopyText(file, kCompileFileNameSize, info->pFileName);
  if (info->pLineNo != nullptr) *info->pLineNo = static_cast<short>(std::min(line, SHRT_MAX));
  CopyText(text, kCompileMessageSize, info->pMessage);
}

/// Stores the first error in the form of TCompileInfo: `'token'message`.
void FillCompileInfo(TCompileInfo* info, const compiler::Compilation& compilation,
                     Message* reason) {
  const auto& diagnostics = compilation.diagnostics;
  const auto first = std::find_if(diagnostics.begin(), diagnostics.end(), [](const auto& d) {
    return d.severity == compiler::Severity::kError;
  });
  const compiler::SourceFile& file = compilation.files[static_cast<size_t>(first->range.file)];
  const std::string_view token =
      std::string_view(file.text())
          .substr(first->range.begin, first->range.end - first->range.begin);
  const int line = file.LineOf(first->range.begin);
  *reason = MakeMessage("{}:{}: {}", "{}:{}: {}", file.path(), line, "");
  reason->en += first->message.en;
  reason->zh += first->message.zh;
  FillCompileInfo(info, file.path(), line,
                  fmt::format("'{}'{}", token.substr(0, token.find('\n')),
                              first->message.In(LanguageFromEnvironment())));
}

/// Refuses a compilation for a reason that is not in a line of the program.
int16_t RefuseFile(ServiceCall& call, int16_t code, TCompileInfo* info, const Message& why) {
  FillCompileInfo(info, call.text(0), 0, why.In(LanguageFromEnvironment()));
  return call.Refuse(code, why);
}

int16_t Compile(ServiceCall& call) {
  const std::string path = call.text(0);
  auto* info = static_cast<TCompileInfo*>(call.arguments[1].host);
  const compiler::OutputPaths paths = compiler::OutputPathsFor(path);
  if (path == paths.bin || path == paths.ini) {
    return RefuseFile(call, kFileNotFound, info,
                      MakeMessage("'{}' is an object file; name the source instead",
                                  "'{}' 是目标文件；应给出源文件", path));
  }
  auto text = compiler::ReadSource(path);
  if (!text.ok()) return RefuseFile(call, kFileNotFound, info, text.error().message);
  const auto compilation = compiler::CompileText(path, std::move(text).value(), compiler::Options{},
                                                 compiler::ReadSource);
  if (!compilation.ok()) {
    FillCompileInfo(info, compilation, &call.reason);
    return vm::kRefused;
  }
  const vm::ObjectFiles files = vm::WriteObject(*compilation.object, false);
  const auto written = WritePairAtomically(paths.bin, files.bin, paths.ini, files.ini);
  if (!written.ok()) return RefuseFile(call, vm::kRefused, info, written.error().message);
  // Nothing is written: hosts whose programs compile do not set the pointers of `info`.
  return vm::kOk;
}

/// The sources of a program, as far as they are where its `.ini` says.
std::vector<RecordedSource> SourcesBeside(const std::string& bin_path, const vm::Image& image) {
  const std::filesystem::path folder = PathOf(bin_path).parent_path();
  std::set<std::string> names;
  for (const vm::Function& function : image.object.functions) names.insert(function.file);
  std::vector<RecordedSource> sources;
  for (const std::string& name : names) {
    std::error_code failed;
    const std::string path =
        FileNameOf(std::filesystem::absolute(folder / PathOf(name), failed).lexically_normal());
    auto text = ReadFile(path, kSourceKind);
    if (text.ok()) sources.push_back({path, std::move(text).value()});
  }
  return sources;
}

int16_t Download(ServiceCall& call) {
  Controller& controller = *call.slot.controller;
  vm::ObjectFiles content;
  const auto loaded = controller.Download(call.text(0), &content);
  if (loaded.ok()) {
    if (call.slot.recorder == nullptr) return vm::kOk;
    RecordedFiles& files = call.slot.files.emplace();
    files.program = std::move(content);
    files.sources = SourcesBeside(call.text(0), *controller.machine().image());
    return vm::kOk;
  }
  const auto code = static_cast<int16_t>(loaded.error().code);
  call.slot.no_program_code = code;
  return call.Refuse(code, loaded.error().message);
}

// --- Names ---------------------------------------------------------------------------------------

/// The program whose names are requested, or nullptr with the reason set.
const vm::Image* ProgramOf(ServiceCall& call) {
  const vm::Image* image = call.slot.controller->machine().image();
  if (image == nullptr) {
    call.reason = {"no program has been downloaded", "尚未成功下载运动程序"};
  }
  return image;
}

int16_t NoFunction(ServiceCall& call, std::string_view name) {
  return call.Refuse(kNameNotFound,
                     MakeMessage("the program has no function '{}'", "程序中没有函数 '{}'", name));
}

int16_t GetFunId(ServiceCall& call) {
  const vm::Image* image = ProgramOf(call);
  if (image == nullptr) return call.slot.no_program_code;
  const int function = vm::FindFunction(*image, call.text(0));
  if (function < 0) return NoFunction(call, call.text(0));
  call.arguments[1].cells[0] = function + 1;
  return vm::kOk;
}

int16_t GetVarId(ServiceCall& call) {
  const vm::Image* image = ProgramOf(call);
  if (image == nullptr) return call.slot.no_program_code;
  const std::string_view name = call.text(1);
  const vm::Symbol* symbol = nullptr;
  if (call.arguments[0].null) {
    symbol = vm::FindGlobal(*image, name);
  } else {
    const int function = vm::FindFunction(*image, call.text(0));
    if (function < 0) return NoFunction(call, call.text(0));
    symbol = vm::FindLocal(*image, function, name);
  }
  if (symbol == nullptr) {
    return call.Refuse(kNameNotFound,
                       call.arguments[0].null
                           ? MakeMessage("the program has no global variable '{}'",
                                         "程序中没有全局变量 '{}'", name)
                           : MakeMessage("function '{}' has no variable '{}'",
                                         "函数 '{}' 中没有变量 '{}'", call.text(0), name));
  }
  // `name` is text, for which there are no cells; the other members are written from the cells.
  auto* info = static_cast<TVarInfo*>(call.arguments[2].host);
  std::memset(info->name, 0, sizeof info->name);
  symbol->name.copy(info->name, sizeof info->name - 1);
  call.arguments[2].cells[0] = symbol->id;
  call.arguments[2].cells[1] = static_cast<double>(symbol->type);
  return vm::kOk;
}

constexpr HostService kServices[] = {
    // command, before_open, function
    {"GT_Open", true, OpenCard},
    {"GT_Close", false, CloseCard},
    {"GT_Reset", false, ResetCard},
    {"GT_GetVersion", false, GetVersion},
    {"GetMacAddress", false, GetMacAddress},
    {"GT_SetCardNo", true, SelectCard},
    {"GT_GetCardNo", true, GetCardNo},
    {"GT_Compile", false, Compile},
    {"GT_Download", false, Download},
    {"GT_GetFunId", false, GetFunId},
    {"GT_GetVarId", false, GetVarId},
};

}  // namespace

const HostLibrary& Library() {
  static const HostLibrary kLibrary = {
      .family = gtcalls::GtsFamily(), .services = kServices, .notice_result = HintAtCardNumber};
  return kLibrary;
}

}  // namespace oncard::runtime
