#include "runtime/host/card_number_hint.h"

#include <atomic>
#include <cstdio>

#include "base/message.h"
#include "runtime/host/library.h"

namespace oncard::runtime {
namespace {

/// The opening of a card with the header for several, `Open(card)`, arrives as Open(card, 0): its
/// second argument is one that the header for a single card sets to 1 by default. Hosts of that one
/// also call Open(0, 0), so this alone proves nothing.
std::atomic<int64_t> opened_as = -1;
std::atomic<bool> said = false;

bool IsOpening(const gtcalls::Command& command) {
  return command.name == LibraryFamily().open_command;
}

/// True if a refused call has a card number where its first parameter should be.
bool HasCardNumber(const gtcalls::Command& command, std::span<const HostArgument> host) {
  if (IsOpening(command)) return host[0].integer != opened_as && host[1].integer == 0;
  if (host.empty()) return false;
  if (host[0].kind == HostArgument::Kind::kPointer) return !IsAddress(host[0].pointer);
  return command.parameters[0].unit == gtcalls::Unit::kIndex &&
         command.parameters[0].minimum == 1 && host[0].integer == 0;
}

}  // namespace

void HintAtCardNumber(const gtcalls::Command& command, std::span<const HostArgument> host,
                      int16_t code) {
  if (code == 0) {
    if (IsOpening(command)) opened_as = host[1].integer == 0 ? host[0].integer : -1;
    return;
  }
  if (opened_as < 0 || !HasCardNumber(command, host) || said.exchange(true)) return;
  const Message hint = MakeMessage(
      "{0} seems to have been called with a card number before its parameters. A multi-card {1}.h "
      "cannot be used with the single-card functions: include oncard's {1}_multi.h instead, or "
      "remove that {1}.h from the host's folder",
      "调用 {0} 时，参数前似乎带有卡号。多卡版 {1}.h 不能与单卡函数一起使用：请改为包含 oncard 的 "
      "{1}_multi.h，或将该 {1}.h 移出主机程序的目录",
      command.name, LibraryFamily().name);
  std::fprintf(stderr, "oncard: %s\n", hint.In(LanguageFromEnvironment()).c_str());
}

}  // namespace oncard::runtime
