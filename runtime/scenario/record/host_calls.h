// The calls that a host makes on a card, for a run that makes them again. call_replay.h has those
// of a record.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "runtime/sim/controller.h"
#include "vm/image.h"

namespace oncard::runtime {

class HostCalls {
 public:
  /// What a call has done.
  struct Done {
    /// As the call log writes it: `GT_GetFunId("add", pFunId) = 0`.
    Message text;
    int16_t code = 0;
    /// The card does not answer as it did, and how.
    std::optional<Message> deviation;
  };

  virtual ~HostCalls() = default;

  /// The programs that the host downloads, each as often as it does.
  virtual const std::vector<std::shared_ptr<const vm::Image>>& programs() const = 0;
  /// True if the card has no surroundings.
  virtual bool bare() const = 0;
  /// Set if it is not known how the host ended.
  virtual std::optional<Message> Incomplete() const = 0;
  /// The calls, and the end if it is known.
  virtual size_t size() const = 0;
  /// When a call acts, in microseconds of the card.
  virtual int64_t TimeUs(size_t number) const = 0;
  /// The call with its inputs: `GT_Bind(0, 1, 0)`; the end: `GT_Close()`.
  virtual std::string Describe(size_t number) const = 0;
  /// False for a call that only reads, and for the end.
  virtual bool ChangesCard(size_t number) const = 0;
  /// Executes a call; the card must be in the cycle of TimeUs(). The end only compares.
  Done Execute(size_t number, Controller* controller) const {
    return Perform(number, controller, true);
  }
  /// The same without a text, which takes most of the time.
  Done ExecuteSilently(size_t number, Controller* controller) const {
    return Perform(number, controller, false);
  }

 private:
  virtual Done Perform(size_t number, Controller* controller, bool described) const = 0;
};

}  // namespace oncard::runtime
