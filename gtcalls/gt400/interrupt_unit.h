// The interrupt unit of a GT400 card: which events of which axes interrupt the host, or how often
// time does, and the interrupt that is in service. Source: GT manual chapter 8. Tested by
// tests/gtcalls/gt400/interrupt_command_test.cc.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gtcalls/gt400/limits.h"
#include "motion/common/rare.h"

namespace oncard::gtcalls::gt400 {

enum class InterruptKind : uint8_t { kNone, kEvent, kTime };

/// The memory of GT_SetBgCommandSet, in which results are written.
struct BackgroundSet {
  std::vector<uint8_t> bytes;

  auto Fields(auto visit) const { return visit(bytes); }
};

/// How the host answers interrupts. It belongs to the host: a reset of the card keeps it.
struct InterruptAnswers {
  bool handler = false;  ///< GT_HookIsr
  bool event = false;    ///< GT_SetIntSyncEvent
  motion::Rare<BackgroundSet> background;

  /// True if a driver answers each interrupt at once, as under Windows.
  bool by_driver() const { return event || background; }
  /// True if anybody answers.
  bool any() const { return handler || by_driver(); }

  auto Fields(auto visit) const { return visit(handler, event, background); }
};

struct InterruptUnit {
  std::array<uint16_t, kAxisMax> masks{};  ///< GT_SetIntrMsk
  bool timed = false;                      ///< GT_TmrIntr
  uint16_t period = 0;                     ///< of time interrupts, sample times; 0: never
  uint16_t elapsed = 0;                    ///< of the period
  InterruptKind service = InterruptKind::kNone;
  uint8_t axis = 0;   ///< of the event interrupt in service
  uint16_t word = 0;  ///< its status word; with a driver that of the last interrupt
  InterruptAnswers answers;

  auto Fields(auto visit) const {
    return visit(masks, timed, period, elapsed, service, axis, word, answers);
  }
};

}  // namespace oncard::gtcalls::gt400
