// The asserts of a card's program (vm::Assert): what must hold whenever a thread is about to
// execute a statement, in the state before it. Bare names in their conditions are first locals of
// that thread, then globals, then all other names of conditions.
//
// Deterministic; not thread-safe. Tested by tests/runtime/assert_watch_test.cc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "runtime/conditions/card_condition.h"
#include "runtime/scenario/file/requirement.h"
#include "runtime/scenario/run/scenario_errors.h"
#include "vm/image.h"

namespace oncard::runtime {

/// The asserts of a program, in the order of its functions and their statements. The names of
/// sources are relative to the program.
std::vector<Requirement> AssertsOf(const vm::Object& object, const std::string& program_path);

bool HasAsserts(const vm::Object& object);

/// An assert that did not hold.
struct FailedAssert {
  size_t number = 0;  ///< in AssertWatch::asserts()
  int thread = 0;     ///< by its number on the card
  Message values;     ///< `x is 5`, in the state before the statement
};

/// A failed assert in words: `does not hold at pick.c:31 in thread 0: x is 5`.
Message Describe(const FailedAssert& failed, const Requirement& requirement);

/// That no thread has executed its statement.
Message DescribeUntestedAssert(const Requirement& requirement);

class AssertWatch {
 public:
  explicit AssertWatch(std::string program_path = {}) : program_path_(std::move(program_path)) {}

  /// The asserts of the controller's program, which has just been started. Adds conditions that
  /// cannot be read, and names that do not exist, to `errors`.
  void Begin(const Controller& controller, ScenarioErrors* errors);
  bool empty() const { return asserts_.empty(); }
  const std::vector<Requirement>& asserts() const { return asserts_; }

  /// To be called before a thread executes its next statement: the first assert before it that does
  /// not hold.
  std::optional<FailedAssert> BeforeStatement(const Controller& controller, int thread);
  /// For those who see only states: to be called in every one of them. The asserts that did not
  /// hold when statements were executed since the last call.
  std::vector<FailedAssert> AfterStatements(const Controller& controller);
  /// Takes the present state as the one of the last call, without looking back.
  void Remember(const Controller& controller);

  /// Takes over which statements threads have executed in other runs of the program.
  void Include(const AssertWatch& other);
  /// The asserts whose statements no thread has executed.
  std::vector<Message> DescribeUntested() const;

 private:
  /// The conditions of a thread's function, for its page; empty: the names are unknown there.
  struct Bound {
    uint8_t function = 0;
    uint8_t page = 0;
    std::vector<std::optional<CardCondition>> conditions = {};
  };
  /// What the next statement of a thread would be checked for.
  struct Ahead {
    int64_t executed = -1;  ///< statements of the thread so far
    size_t begin = 0;       ///< the asserts before it: [begin, end)
    size_t end = 0;
    std::optional<FailedAssert> failed = {};
  };

  Ahead Look(const Controller& controller, int thread);
  void NoteReached(const Ahead& ahead);
  const Bound& BoundOf(const Controller& controller, int thread);

  std::string program_path_;
  std::shared_ptr<const vm::Image> image_;
  std::vector<Requirement> asserts_;
  std::vector<size_t> first_;  ///< of each function, its first one in asserts_
  std::vector<bool> reached_;
  std::array<std::optional<Bound>, vm::kThreadCount> bound_;  ///< of threads that have met one
  std::array<Ahead, vm::kThreadCount> ahead_;
};

}  // namespace oncard::runtime
