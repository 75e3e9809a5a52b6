// GT_LoadConfig. Source: GTS manual 4.4 and chapter 13.
// Tested by tests/gtcalls/card_config_test.cc.
#include <cstring>

#include "base/files.h"
#include "gtcalls/gts/card_config.h"
#include "gtcalls/gts/commands/motion_support.h"

namespace oncard::gtcalls::gts {
namespace {

/// Assumption: a file that cannot be read gives the code that GT_Download would return.
constexpr int16_t kFileNotFound = 2007;

}  // namespace

int16_t GT_LoadConfig(Call& call) {
  const auto* path = static_cast<const char*>(call.arguments[0].host);
  if (std::strlen(path) > kConfigPathMax) {
    return call.Refuse(
        vm::kBadParameter,
        MakeMessage("the file name has {0} characters; at most {1} are allowed",
                    "文件名有 {0} 个字符；最多允许 {1} 个", std::strlen(path), kConfigPathMax));
  }
  motion::MotionCore& core = call.card.motion;
  for (size_t i = 0; i < core.axis_count(); ++i) {
    const int16_t code = CheckAtRest(call, i);
    if (code != vm::kOk) return code;
  }
  const auto& read_file = call.card.read_file;
  const auto text = read_file ? read_file(path) : ReadFile(path, kConfigKind);
  if (!text.ok()) return call.Refuse(kFileNotFound, text.error().message);
  const CardConfig config = ParseCardConfig(text.value());
  core.DisableGantry();
  ApplyCardConfig(config, &core);
  for (const Message& remark : config.remarks) call.Note(remark);
  return vm::kOk;
}

}  // namespace oncard::gtcalls::gts
