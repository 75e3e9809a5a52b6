#include "gtcalls/ge/ges_unsupported.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

namespace oncard::gtcalls::ges {
namespace {

enum Reason {
#define REASON(id, en, zh) id,
#include "gtcalls/ge/ges_unsupported.def"
};

struct UnsupportedRow {
  std::string_view command;
  Reason reason;
};

constexpr UnsupportedRow kUnsupportedRows[] = {
#define UNSUPPORTED(name, id) {#name, id},
#include "gtcalls/ge/ges_unsupported.def"
};

}  // namespace

const Message* WhyUnsupported(const Command& command) {
  // Never destroyed: objects of a host may make calls while the process exits.
  static const auto& reasons = *new const std::vector<Message>{
#define REASON(id, en, zh) {en, zh},
#include "gtcalls/ge/ges_unsupported.def"
  };
  const auto* row =
      std::find_if(std::begin(kUnsupportedRows), std::end(kUnsupportedRows),
                   [&](const UnsupportedRow& r) { return r.command == command.name; });
  return row == std::end(kUnsupportedRows) ? nullptr : &reasons[row->reason];
}

}  // namespace oncard::gtcalls::ges
