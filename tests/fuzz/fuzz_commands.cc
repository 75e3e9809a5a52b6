// Calls commands as a careless host does: any command, any number, NULL or large enough memory, in
// any order, from one thread or many. Half of the inputs of one thread only call commands of
// coordinate systems, after the set-up of one with the multi-axis look-ahead.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "LookAheadEx.h"
#include "compiler/compiler.h"
#include "gtcalls/gts/catalogue.h"
#include "runtime/host/host_api.h"
#include "tests/fuzz/argument_bytes.h"
#include "tests/fuzz/fuzz.h"
#include "vm/object_writer.h"

namespace oncard::fuzz {
namespace {

using gtcalls::Command;
using gtcalls::Passing;
using runtime::HostArgument;

constexpr int kThreads = 32;
/// Space for the largest number of elements of the largest structure that a pointer can refer to.
constexpr size_t kBufferSize = size_t{1} << 20;

/// A folder with a source and its object, deleted at the end of the process.
class ProgramFolder {
 public:
  ProgramFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "oncard_fuzz_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
    std::filesystem::copy_file(ONCARD_SOURCE_DIR "/tests/fuzz/seeds/race.c", path_ + "/race.c");
    std::filesystem::copy_file(ONCARD_SOURCE_DIR "/tests/fuzz/seeds/card.cfg", path_ + "/card.cfg");
    names_ = {path_ + "/race.c",
              path_ + "/race.bin",
              path_ + "/card.cfg",
              path_,
              "",
              "t0",
              "t1",
              "sum",
              "turns",
              "i",
              std::string(300, 'n'),
              "\x1B\xFF"};
  }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;
  ~ProgramFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::string path_;
  std::vector<std::string> names_;
};

/// One thread of a host.
class Host {
 public:
  explicit Host(const std::vector<std::string>& names) : names_(names) {}

  int16_t Call(int card, const Command& command, Bytes* bytes) {
    std::array<HostArgument, gtcalls::kParameterMax> arguments{};
    for (size_t i = 0; i < command.parameters.size(); ++i) {
      arguments[i] = Argument(command, i, bytes);
    }
    const int16_t code = runtime::CallCard(card, command.number,
                                           std::span(arguments).first(command.parameters.size()));
    // The host owns the text that it is given.
    if (code == 0 && command.name == "GT_GetVersion") {
      std::free(*static_cast<char**>(arguments[0].pointer));
    }
    return code;
  }

  void CallAll(int card, Bytes bytes) {
    const auto commands = gtcalls::GtsCatalogue().commands();
    while (!bytes.empty()) {
      const Command& command = commands[bytes.Value<uint16_t>() % commands.size()];
      Call(card, command, &bytes);
    }
  }

  /// The same with the commands of a coordinate system that has a look-ahead, and GT_CrdStart.
  void CallPath(int card, Bytes bytes) {
    static const std::vector<const Command*> commands = PathCommands();
    SetUpPath(card, bytes.Byte());
    while (!bytes.empty()) {
      Call(card, *commands[bytes.Value<uint16_t>() % commands.size()], &bytes);
    }
  }

 private:
  static std::vector<const Command*> PathCommands() {
    std::vector<const Command*> commands;
    for (const Command& command : gtcalls::GtsCatalogue().commands()) {
      const bool of_path = !command.parameters.empty() && command.parameters[0].name == "crd";
      if (of_path || command.name == "GT_CrdStart") commands.push_back(&command);
    }
    return commands;
  }

  static void SetUpPath(int card, uint8_t choice) {
    const auto call = [card](std::string_view name, std::initializer_list<HostArgument> given) {
      std::vector<HostArgument> arguments(given);
      const Command* command = gtcalls::GtsCatalogue().Find(name);
      arguments.resize(command->parameters.size());
      runtime::CallCard(card, command->number, arguments);
    };
    const auto number = [](int64_t value) {
      HostArgument argument;
      argument.integer = value;
      return argument;
    };
    const auto pointer = [](void* to) {
      HostArgument argument;
      argument.kind = HostArgument::Kind::kPointer;
      argument.pointer = to;
      return argument;
    };
    TCrdPrm crd = {};
    TLookAheadParameter parameter = {};
    crd.dimension = 4;
    crd.synVelMax = 500;
    crd.synAccMax = 10;
    for (short i = 0; i < 4; ++i) crd.profile[i] = static_cast<short>(i + 1);
    parameter.lookAheadNum = 1 + choice / 8;
    parameter.time = 0.01;
    parameter.radiusRatio = 1;
    parameter.scale[0] = 1000;
    for (short i = 0; i < LA_AXIS_NUM; ++i) {
      parameter.vMax[i] = parameter.aMax[i] = parameter.DVMax[i] = 500;
      parameter.axisRelation[i] = static_cast<short>(i + 1);
    }
    call("GT_SetCrdPrm", {number(1), pointer(&crd)});
    call("GT_SetupLookAheadCrd", {number(1), number(choice & 1)});
    call("GT_InitLookAheadEx",
         {number(1), pointer(&parameter), number(0), number(choice >> 1 & 1), pointer(nullptr)});
  }

  HostArgument Argument(const Command& command, size_t index, Bytes* bytes) {
    const gtcalls::Parameter& parameter = command.parameters[index];
    HostArgument argument;
    if (parameter.passing != Passing::kValue) {
      argument.kind = HostArgument::Kind::kPointer;
      argument.pointer = Pointer(command, index, bytes);
    } else if (parameter.type == gtcalls::Scalar::kDouble) {
      argument.kind = HostArgument::Kind::kReal;
      argument.real = bytes->Real();
    } else {
      argument.integer = bytes->Integer(parameter.type);
    }
    return argument;
  }

  void* Pointer(const Command& command, size_t index, Bytes* bytes) {
    const gtcalls::Parameter& parameter = command.parameters[index];
    const uint8_t kind = bytes->Byte();
    if (kind % 16 == 0) return nullptr;
    if (parameter.passing == Passing::kText) {
      return const_cast<char*>(names_[kind % names_.size()].c_str());
    }
    std::unique_ptr<char[]>& buffer = buffers_[index];
    if (buffer == nullptr) buffer = std::make_unique<char[]>(kBufferSize);
    // A host fills structures with numbers; pointers in them must be its own.
    const bool holds_pointers =
        parameter.structure != nullptr &&
        std::any_of(parameter.structure->members.begin(), parameter.structure->members.end(),
                    [](const gtcalls::Member& member) { return member.pointer; });
    if (holds_pointers) {
      std::memset(buffer.get(), 0, kBufferSize);
    } else {
      bytes->Copy(buffer.get(), kind);
    }
    return buffer.get();
  }

  const std::vector<std::string>& names_;
  std::array<std::unique_ptr<char[]>, gtcalls::kParameterMax> buffers_;
};

const ProgramFolder& Folder() {
  static const ProgramFolder folder;
  ::setenv("ONCARD_CLOCK", "virtual", 1);
  return folder;
}

/// Opens a card again and loads a program.
void Open(Host* host, int card) {
  Bytes none("");
  host->Call(card, *gtcalls::GtsCatalogue().Find("GT_Close"), &none);
  host->Call(card, *gtcalls::GtsCatalogue().Find("GT_Open"), &none);
}

}  // namespace

void FuzzCommands(std::string_view bytes) {
  static Host host(Folder().names());
  Open(&host, 0);
  if (bytes.size() % 2 == 0) {
    host.CallAll(0, Bytes(bytes));
  } else {
    host.CallPath(0, Bytes(bytes));
  }
}

void FuzzCommandsOfThreads(std::string_view bytes) {
  static Host opener(Folder().names());
  for (const int card : {0, 1}) Open(&opener, card);
  // They keep their memory between inputs.
  static std::array<std::unique_ptr<Host>, kThreads> hosts;
  const size_t part = bytes.size() / kThreads + 1;
  std::vector<std::thread> threads;
  for (size_t i = 0; i * part < bytes.size(); ++i) {
    if (hosts[i] == nullptr) hosts[i] = std::make_unique<Host>(Folder().names());
    threads.emplace_back([share = bytes.substr(i * part, part), i] {
      hosts[i]->CallAll(static_cast<int>(i % 2), Bytes(share));
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace oncard::fuzz
