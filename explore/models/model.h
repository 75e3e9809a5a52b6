// A motion program as a transition system that the explorer searches: threads that execute one
// statement at a time over one array of cells.
//
// The program is translated once, from its instructions to steps over numbered cells: its globals,
// then each thread's locals and registers. A step is executed, or undone from a journal; the state
// is never copied as a whole. The hash of the state is updated with every write. The meaning of
// statements is that of vm/handlers.def.
//
// Only variables are modelled here: a program that calls GT commands needs the card and is
// rejected. Deterministic; not thread-safe: one model per searching thread. Tested by
// tests/explore/model_test.cc.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "explore/models/state_key.h"
#include "explore/models/statement_coverage.h"
#include "vm/machine.h"
#include "vm/object.h"

namespace oncard::explore {

inline constexpr int kThreadMax = 32;

/// A thread of the program to be explored.
struct ThreadSetup {
  int thread = 0;    ///< number on the card
  int function = 0;  ///< index in the image
  int page = 0;
};

/// The threads of a machine that a program is bound to, in the order of their numbers.
std::vector<ThreadSetup> BoundThreads(const vm::Machine& machine);

/// The shared cells that a statement reads and the one that it writes. Statements of different
/// threads depend on each other if they access a common cell and one of them writes it.
struct AccessSet {
  /// Globals that are read to check a statement (StatementCheck).
  static constexpr int kCheckedMax = 11;
  /// A statement itself reads up to five: two elements with global indices, and the index of the
  /// element that is written.
  static constexpr int kReadMax = 5 + kCheckedMax;
  static constexpr uint32_t kNone = ~uint32_t{0};

  std::array<uint32_t, kReadMax> reads{};
  uint32_t read_count = 0;
  uint32_t write = kNone;

  void Read(uint32_t cell) { reads[read_count++] = cell; }
  /// Reads a cell to check the statement, unless it is there already or there is no room.
  void ReadToCheck(uint32_t cell) {
    for (uint32_t i = 0; i < read_count; ++i) {
      if (reads[i] == cell) return;
    }
    if (read_count < kReadMax) Read(cell);
  }
  bool empty() const { return read_count == 0 && write == kNone; }
  /// True if it reads the same cells in the same order, and writes the same one.
  bool SameAs(const AccessSet& other) const {
    return write == other.write &&
           std::ranges::equal(std::span(reads).first(read_count),
                              std::span(other.reads).first(other.read_count));
  }
  bool Touches(uint32_t cell) const {
    for (uint32_t i = 0; i < read_count; ++i) {
      if (reads[i] == cell) return true;
    }
    return write == cell;
  }
  bool DependsOn(const AccessSet& other) const {
    return (write != kNone && other.Touches(write)) ||
           (other.write != kNone && Touches(other.write));
  }
};

/// The name of a slot among the variables, `v` or `a[3]`; empty if no variable has it.
std::string NameOfSlot(const std::vector<vm::Symbol>& symbols, uint32_t id);

/// The state of a thread.
enum class ThreadEnd : uint8_t {
  kRunning,
  kFinished,
  kDivisionByZero,
  kIndexOutOfBounds,
  kCheckFailed  ///< its next statement has not met a StatementCheck, and is not executed
};

/// True for the end with an error.
constexpr bool Fails(ThreadEnd end) {
  return end != ThreadEnd::kRunning && end != ThreadEnd::kFinished;
}

class Model;

/// A condition that statements must meet when they are executed. It belongs to what such a
/// statement does: the statement reads what the condition names, and its thread ends where it does
/// not hold. So an engine that is exact for a model is exact for a model with checks.
struct StatementCheck {
  int requirement = 0;                 ///< its number, for Model::FailedCheck()
  std::vector<uint32_t> globals = {};  ///< the cells of those that it names
  std::vector<uint32_t> locals = {};   ///< the slots of those of the executing thread that it names
  bool sees_others = false;  ///< it names something else: a local or the result of a thread
  std::function<bool(const Model&)> holds = {};
};

class Model {
 public:
  /// The running threads of a virtual machine, each at its first statement, and its current
  /// variables. Fails if no thread runs, when the program calls GT commands, or has more than 2^24
  /// cells.
  static Result<Model> Create(const vm::Machine& machine);

  int thread_count() const { return static_cast<int>(threads_.size()); }
  const ThreadSetup& setup(int thread) const { return threads_[Index(thread)].setup; }
  const vm::Image& image() const { return *image_; }
  /// Same pointer, shared.
  const std::shared_ptr<const vm::Image>& shared_image() const { return image_; }

  // --- Checks: before the first step -------------------------------------------------------------

  /// A thread's statement must meet the check before it is executed.
  void CheckBefore(int thread, size_t position, StatementCheck check);
  /// Every statement that writes one of the globals of the check must meet it afterwards.
  void CheckAfterWrites(const StatementCheck& check);
  /// True if what statements read and write tells which of them depend on each other: no check
  /// names more than globals and its own thread's locals, nor more globals than there is room for.
  bool ChecksAreLocal() const { return checks_are_local_; }
  /// Calls `visit` with every check of a thread's statement.
  template <typename Visit>
  void ForEachCheck(int thread, size_t position, const Visit& visit) const {
    const Statement& statement = threads_[Index(thread)].statements[position];
    for (const uint32_t check : statement.before) visit(checks_[check]);
    for (const uint32_t check : statement.after) visit(checks_[check]);
  }

  /// From now on this model, and those copied from it, note each statement that they execute in
  /// `coverage`, which must outlive them. If nothing is known there, it is as if nothing had been
  /// executed.
  void NoteIn(StatementCoverage* coverage);

  /// True if a thread can jump back: otherwise every run ends.
  bool HasLoops() const;

  /// True if two threads execute the same statements, none of which must meet a check, and their
  /// locals have the same values. Before the first step.
  bool Alike(int thread, int other) const;

  /// For each statement of a thread, the slots of its locals that cannot matter any more before it
  /// is executed (thread_future.h); of a thread that has ended none can. ForgetDeadLocals() does
  /// nothing without it.
  void SetDeadLocals(int thread, std::vector<std::vector<uint32_t>> dead) {
    threads_[Index(thread)].dead = std::move(dead);
  }

  // --- The current state -------------------------------------------------------------------------
  // Threads are numbered from 0, in the order of their numbers on the card.

  bool Running(int thread) const { return End(thread) == ThreadEnd::kRunning; }
  ThreadEnd End(int thread) const {
    return static_cast<ThreadEnd>(std::min(cells_[threads_[Index(thread)].end_cell], kFirstCheck));
  }
  /// The requirement of the check with which a thread has ended (kCheckFailed).
  int FailedCheck(int thread) const {
    return static_cast<int>(cells_[threads_[Index(thread)].end_cell] - kFirstCheck);
  }
  /// Bit n: thread n can execute a step.
  uint32_t runnable() const { return runnable_; }
  /// True if the next statement of a running thread can never access a shared cell.
  bool NextIsPrivate(int thread) const { return !NextStatement(threads_[Index(thread)]).shared; }
  /// The cells that the next statement of a running thread accesses, and those that are read to
  /// check it.
  AccessSet NextAccess(int thread) const;
  /// The same without what is read to check it.
  AccessSet NextOwnAccess(int thread) const;
  /// Index of the next statement of a running thread; of the last one if the thread has ended.
  int Position(int thread) const {
    return static_cast<int>(cells_[threads_[Index(thread)].position_cell]);
  }
  /// Source line of that statement, 0 when unknown.
  int Line(int thread) const;
  /// Raw value that a finished thread returned.
  int64_t ReturnValue(int thread) const { return cells_[threads_[Index(thread)].result_cell]; }
  /// Raw content of a slot; 0 if the program does not use it.
  int64_t Read(const vm::SlotAddress& slot) const;
  /// Statements executed since the start.
  int64_t depth() const { return static_cast<int64_t>(marks_.size()); }
  /// The key of the whole state; only while TrackKey() is on.
  StateKey key() const { return key_; }
  /// Updates key() with every step, which doubles the cost of a step. On by default.
  void TrackKey(bool on);
  /// The key of the globals, without and with the return values of the threads.
  StateKey GlobalsKey() const;
  StateKey FinalKey() const;

  // --- Parts of the state (thread_states.h) ------------------------------------------------------

  /// True if the cells that a statement accesses are determined by its thread alone: no index is
  /// global, and ChecksAreLocal().
  bool AccessesAreLocal() const;
  uint32_t global_count() const { return global_count_; }
  /// Raw content of a global; cells are counted from 0.
  int64_t Global(uint32_t cell) const { return cells_[cell]; }
  /// Number of slots of a thread's locals.
  uint32_t local_count(int thread) const { return threads_[Index(thread)].local_count; }
  /// The variables, position, end and return value of a thread.
  std::span<const int64_t> ThreadCells(int thread) const;
  /// The number of the first of them, for key().
  uint32_t FirstThreadCell(int thread) const { return threads_[Index(thread)].first_local; }
  /// Replace a part of the state, which no step may undo: only before the first step, and while the
  /// key is not tracked.
  void SetGlobal(uint32_t cell, int64_t value) { cells_[cell] = value; }
  void SetThreadCells(int thread, std::span<const int64_t> cells);
  /// Makes the current state the start: the steps before it cannot be undone any more.
  void ForgetSteps();

  // --- Steps -------------------------------------------------------------------------------------

  /// Executes one statement of a running thread.
  void Step(int thread);
  /// Executes a thread's statements up to the next one that accesses a shared cell, or to its end,
  /// at most `limit` of them. Returns their number.
  int64_t StepPrivate(int thread, int64_t limit);
  /// Sets the locals of a thread that cannot matter any more to 0, as a part of the last step;
  /// there must be one, unless steps are forgotten before any is undone.
  void ForgetDeadLocals(int thread);
  /// Undoes the last step.
  void Undo();
  /// The thread of a step; steps are counted from 0.
  int StepThread(int64_t step) const { return marks_[static_cast<size_t>(step)].thread; }

 private:
  enum class Place : uint8_t { kConstant, kCell, kElement };
  /// An operand: a constant, a cell, or an element whose index is in a cell.
  struct Operand {
    Place place = Place::kConstant;
    bool shared = false;        ///< the cell, or the array, is global
    bool index_shared = false;  ///< kElement: the index is global
    uint32_t cell = 0;          ///< kCell, or element 0
    uint32_t size = 0;          ///< kElement
    uint32_t index_cell = 0;    ///< kElement
    int64_t constant = 0;
  };
  struct Statement {
    vm::Opcode opcode = vm::Opcode::kReturn;
    uint16_t op = 0;
    vm::DataType type = vm::DataType::kInt;
    Operand a;
    Operand b;
    Operand target;
    int32_t displacement = 0;
    bool shared = false;           ///< an operand is global, or a check reads one
    std::vector<uint32_t> before;  ///< checks: their places in checks_
    std::vector<uint32_t> after;
  };
  struct Thread {
    ThreadSetup setup;
    std::vector<Statement> statements;
    uint32_t position_cell = 0;
    uint32_t end_cell = 0;
    uint32_t result_cell = 0;
    uint32_t first_local = 0;  ///< cell of slot 0 of its page
    uint32_t local_count = 0;
    uint8_t* noted = nullptr;  ///< StatementCoverage::BitsOf(); nullptr: nothing is noted
    std::vector<std::vector<uint32_t>> dead;  ///< SetDeadLocals()
  };
  struct Change {
    uint32_t cell = 0;
    int64_t old = 0;
  };

  Model() = default;
  Result<void> AddThread(int number, const vm::ThreadState& state, const vm::Machine& machine);
  static size_t Index(int thread) { return static_cast<size_t>(thread); }
  static constexpr int64_t kFirstCheck = static_cast<int64_t>(ThreadEnd::kCheckFailed);
  void AddCheck(uint32_t check, Statement* statement, std::vector<uint32_t>* list);
  /// The first of the checks that does not hold, as the end of a thread; empty: all hold.
  std::optional<int64_t> FailedOf(const std::vector<uint32_t>& checks) const;
  const Statement& NextStatement(const Thread& thread) const {
    return thread.statements[static_cast<size_t>(cells_[thread.position_cell])];
  }
  Operand Translate(const vm::Operand& operand, const Thread& thread, vm::DataType type) const;
  Statement Translate(const vm::Instruction& instruction, const Thread& thread) const;
  /// The cell of an operand that is not a constant; kNoCell when the index is out of bounds.
  uint32_t CellOf(const Operand& operand) const;
  /// False when the index is out of bounds.
  bool Load(const Operand& operand, int64_t* value) const;
  void Note(const Operand& operand, bool written, AccessSet* set) const;
  /// Writes a cell, with an entry in the journal.
  void Write(uint32_t cell, int64_t value);
  /// Writes a cell whose value is restored by the marks.
  void Replace(uint32_t cell, int64_t value);
  void Finish(int thread, int64_t end);
  /// Notes what a thread's next statement does (StatementCoverage).
  void NoteNext(const Thread& thread, uint8_t bits) {
    if (thread.noted != nullptr) thread.noted[cells_[thread.position_cell]] |= bits;
  }
  void NoteCondition(const Thread& thread, bool holds) {
    NoteNext(thread, holds ? StatementCoverage::kHeld : StatementCoverage::kNotHeld);
  }
  /// Executes a statement that is to be checked. Returns the thread's end.
  int64_t ExecuteChecked(const Statement& statement, const Thread& thread);
  ThreadEnd Execute(const Statement& statement, const Thread& thread);

  std::shared_ptr<const vm::Image> image_;
  std::vector<Thread> threads_;
  std::vector<int64_t> cells_;
  uint32_t global_count_ = 0;
  int wrap_shift_ = 0;
  uint32_t runnable_ = 0;
  StateKey key_;
  bool track_key_ = true;
  struct Mark {
    uint32_t journal = 0;   ///< its size before the step
    uint32_t runnable = 0;  ///< before the step
    uint32_t position = 0;  ///< position of the thread before the step
    uint8_t thread = 0;     ///< the thread of the step
    StateKey key;           ///< before the step; while it is tracked
  };
  /// Takes the changes since a mark back.
  void GoBackTo(const Mark& mark);

  std::vector<Change> journal_;
  std::vector<Mark> marks_;
  std::vector<StatementCheck> checks_;
  bool checks_are_local_ = true;
};

}  // namespace oncard::explore
