// Watching values. Source: GE manual 10.1. Tested by tests/gtcalls/ge/watch_test.cc.
#include <iterator>
#include <span>
#include <vector>

#include "gtcalls/card_elements.h"
#include "gtcalls/ge/commands/commands.h"

namespace oncard::gtcalls::ge {

int16_t GT_SetWatch(Call& call) {
  WatchConfig config{};
  for (size_t axis = 0; axis < call.card.motion.axis_count(); ++axis) {
    config[axis] = static_cast<uint16_t>(call.cells(0)[axis]);
  }
  const auto size = static_cast<uint16_t>(call.integer(1));
  const size_t words = size * WordsOf(config);
  if (words > kWatchWords) {
    call.cause = kOverflow;
    return call.Refuse(vm::kBadParameter, MakeMessage("{0} samples need {1} words; there are {2}",
                                                      "{0} 次采样需要 {1} 个字；共有 {2} 个", size,
                                                      words, kWatchWords));
  }
  StateOf(call).watch.SetUp(config, size);
  return vm::kOk;
}

int16_t GT_StartWatch(Call& call) {
  if (!StateOf(call).watch.batches.set_up()) {
    call.cause = kIllegal;
    return call.Refuse(vm::kRefused, {"nothing is watched, call GT_SetWatch first",
                                      "尚未设置监测数据，请先调用 GT_SetWatch"});
  }
  StateOf(call).watch.Start(static_cast<uint16_t>(call.integer(0)));
  return vm::kOk;
}

int16_t GT_GetWatch(Call& call) {
  Watch& watch = StateOf(call).watch;
  if (!watch.started) {
    call.cause = kIllegal;
    return call.Refuse(vm::kRefused, {"nothing is watched, call GT_StartWatch first",
                                      "尚未启动监测，请先调用 GT_StartWatch"});
  }
  HostArrays arrays(call.cells(0), call.command.parameters[0]);
  constexpr size_t kValues = std::size(kWatchedValues);
  std::vector<size_t> watched;  // the arrays for the values of a sample, in its order
  for (size_t array = 0; array < arrays.arrays(); ++array) {
    if ((watch.config[array / kValues] & kWatchedValues[array % kValues]) == 0) {
      arrays.LeaveOut(array);
    } else if (arrays.given(array)) {
      watched.push_back(array);
    } else {
      call.cause = kIllegal;
      return call.Refuse(vm::kBadParameter, {"buffer has no array for a watched value",
                                             "buffer 中没有某个监测数据的数组"});
    }
  }
  const std::span<const double> batch = watch.batches.FullBank();
  for (size_t i = 0; i < batch.size(); ++i) {
    arrays.Set(watched[i % watched.size()], i / watched.size(), batch[i]);
  }
  call.Set(1, batch.empty() ? 0 : 1);
  if (!batch.empty()) watch.batches.FreeBank();
  return vm::kOk;
}

int16_t GT_StopWatch(Call& call) {
  StateOf(call).watch.batches.Stop();
  return vm::kOk;
}

}  // namespace oncard::gtcalls::ge
