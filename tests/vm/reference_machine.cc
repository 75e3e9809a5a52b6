#include "tests/vm/reference_machine.h"

#include <fmt/core.h>

#include "tests/vm/program_builder.h"

namespace oncard::vm {
namespace {

constexpr int64_t kRawOne = 65536;  // the raw double 1.0

constexpr int kDivisionByZero = 100;
constexpr int kIndexOutOfBounds = 101;
constexpr int kOutputBeyondStorage = 102;

// An int is in the low 32 bits of its slot.
int64_t AsInt(int64_t value) {
  const int64_t low = value & 0xFFFFFFFF;
  return low > INT32_MAX ? low - 0x100000000 : low;
}

// value / 2^shift, rounded down.
int64_t ShiftRight(int64_t value, int64_t shift) {
  const int64_t divisor = int64_t{1} << shift;
  return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

int64_t IntResult(BinaryOperator op, int64_t a, int64_t b) {
  const int64_t shift = ((b % 32) + 32) % 32;
  switch (op) {
    case BinaryOperator::kAdd:
      return AsInt(a + b);
    case BinaryOperator::kSubtract:
      return AsInt(a - b);
    case BinaryOperator::kMultiply:
      return AsInt(a * b);
    case BinaryOperator::kDivide:
      return AsInt(a / b);
    case BinaryOperator::kRemainder:
      return a % b;
    case BinaryOperator::kLogicalAnd:
      return a != 0 && b != 0 ? 1 : 0;
    case BinaryOperator::kLogicalOr:
      return a != 0 || b != 0 ? 1 : 0;
    case BinaryOperator::kEqual:
      return a == b ? 1 : 0;
    case BinaryOperator::kNotEqual:
      return a != b ? 1 : 0;
    case BinaryOperator::kLess:
      return a < b ? 1 : 0;
    case BinaryOperator::kGreater:
      return a > b ? 1 : 0;
    case BinaryOperator::kLessEqual:
      return a <= b ? 1 : 0;
    case BinaryOperator::kGreaterEqual:
      return a >= b ? 1 : 0;
    case BinaryOperator::kAnd:
      return a & b;
    case BinaryOperator::kOr:
      return a | b;
    case BinaryOperator::kXor:
      return a ^ b;
    case BinaryOperator::kShiftLeft:
      return AsInt(a * (int64_t{1} << shift));
    case BinaryOperator::kShiftRight:
      return ShiftRight(a, shift);
  }
  return 0;
}

}  // namespace

int64_t ReferenceMachine::WrapDouble(__int128 raw) const {
  const int bits = object_.double_format == DoubleFormat::k32_16 ? 48 : 32;
  const __int128 range = __int128{1} << bits;
  __int128 rest = raw % range;
  if (rest < -range / 2) rest += range;
  if (rest >= range / 2) rest -= range;
  return static_cast<int64_t>(rest);
}

// --- Threads -------------------------------------------------------------------------------------

void ReferenceMachine::Bind(size_t thread, size_t function, size_t page) {
  threads[thread] = {};
  threads[thread].run = Run::kStopped;
  threads[thread].function = function;
  threads[thread].page = page;
}

void ReferenceMachine::Start(size_t thread) {
  const size_t function = threads[thread].function;
  const size_t page = threads[thread].page;
  threads[thread] = {};
  threads[thread].run = Run::kRunning;
  threads[thread].started = true;
  threads[thread].function = function;
  threads[thread].page = page;
}

bool ReferenceMachine::Awake(const Thread& thread) const {
  return thread.wake_cycle <= cycle_ &&
         (!thread.waiting || AsInt(*thread.wait_slot) == thread.wait_value);
}

bool ReferenceMachine::CanGoOn(const Thread& thread) const {
  return thread.run == Run::kRunning && Awake(thread);
}

int ReferenceMachine::Choose() {
  if (turn_left_ > 0 && CanGoOn(threads[next_])) return static_cast<int>(next_);
  if (turn_left_ > 0) next_ = (next_ + 1) % threads.size();
  turn_left_ = 0;
  for (size_t i = 0; i < threads.size(); ++i) {
    const size_t candidate = (next_ + i) % threads.size();
    if (!CanGoOn(threads[candidate])) continue;
    next_ = candidate;
    turn_left_ = quantum_;
    return static_cast<int>(candidate);
  }
  return -1;
}

int64_t ReferenceMachine::Execute(int64_t budget) {
  int64_t executed = 0;
  FinishAwakened();
  while (executed < budget) {
    const int chosen = Choose();
    if (chosen < 0) break;
    Thread& thread = threads[static_cast<size_t>(chosen)];
    Step(thread);
    ++executed;
    if (segments.empty() || segments.back().thread != chosen) {
      segments.push_back({static_cast<uint8_t>(chosen), 0});
    }
    ++segments.back().statements;
    --turn_left_;
    if (turn_left_ == 0 || !CanGoOn(thread)) {
      next_ = (next_ + 1) % threads.size();
      turn_left_ = 0;
    }
  }
  executed_ += executed;
  return executed;
}

void ReferenceMachine::FinishAwakened() {
  for (Thread& thread : threads) {
    if (!CanGoOn(thread)) continue;
    const size_t size = object_.functions[thread.function].instructions.size();
    if (thread.pc < size) continue;
    Finish(thread);
  }
}

void ReferenceMachine::Finish(Thread& thread) {
  thread.run = Run::kStopped;
  thread.result = 0;
  thread.waiting = false;
  thread.wake_cycle = 0;
  if (thread.pc > 0) --thread.pc;
}

void ReferenceMachine::FaultAt(Thread& thread, int code, int64_t value, int64_t limit) {
  thread.run = Run::kFaulted;
  thread.error = code;
  thread.fault_value = value;
  thread.fault_limit = limit;
}

// --- Statements ----------------------------------------------------------------------------------

void ReferenceMachine::Step(Thread& thread) {
  thread.waiting = false;
  thread.wake_cycle = 0;
  ++thread.executed;
  const Instruction& instruction = object_.functions[thread.function].instructions[thread.pc];
  bool next = false;
  switch (instruction.opcode) {
    case Opcode::kUnary:
      next = StepUnary(thread, instruction);
      break;
    case Opcode::kBinary:
      next = StepBinary(thread, instruction);
      break;
    case Opcode::kJump: {
      int64_t condition = 0;
      Load(thread, instruction.operands[0], DataType::kInt, &condition);
      if (condition != 0) {
        thread.pc = static_cast<size_t>(static_cast<int64_t>(thread.pc) + instruction.displacement);
      } else {
        next = true;
      }
      break;
    }
    case Opcode::kReturn:
      next = StepReturn(thread, instruction);
      break;
    case Opcode::kCommand:
      next = StepCommand(thread, instruction);
      break;
  }
  if (next) ++thread.pc;
  FinishAwakened();
}

int64_t* ReferenceMachine::Place(Thread& thread, const Operand& operand) {
  const auto slot = [&](Storage storage, size_t id) {
    return storage == Storage::kGlobal ? &globals[id] : &pages[thread.page][id];
  };
  if (const auto* variable = std::get_if<Variable>(&operand)) {
    return slot(variable->storage, variable->id);
  }
  const auto& element = std::get<Element>(operand);
  const int64_t index = AsInt(*slot(element.index.storage, element.index.id));
  if (index < 0 || index >= element.size) {
    FaultAt(thread, kIndexOutOfBounds, index, element.size);
    return nullptr;
  }
  return slot(element.storage, element.base + static_cast<size_t>(index));
}

bool ReferenceMachine::Load(Thread& thread, const Operand& operand, DataType type, int64_t* value) {
  if (const auto* literal = std::get_if<Immediate>(&operand)) {
    *value = type == DataType::kDouble ? literal->raw : literal->raw / kRawOne;
    return true;
  }
  const int64_t* place = Place(thread, operand);
  if (place == nullptr) return false;
  *value = type == DataType::kDouble ? *place : AsInt(*place);
  return true;
}

bool ReferenceMachine::StepUnary(Thread& thread, const Instruction& instruction) {
  int64_t a = 0;
  if (!Load(thread, instruction.operands[0], instruction.type, &a)) return false;
  int64_t* const target = Place(thread, instruction.operands[1]);
  if (target == nullptr) return false;
  switch (static_cast<UnaryOperator>(instruction.op)) {
    case UnaryOperator::kCopy:
      *target = a;
      break;
    case UnaryOperator::kNot:
      *target = a == 0 ? 1 : 0;
      break;
    case UnaryOperator::kInvert:
      *target = -a - 1;
      break;
    case UnaryOperator::kAbs:
      *target = AsInt(a < 0 ? -a : a);
      break;
    case UnaryOperator::kFabs:
      *target = WrapDouble(a < 0 ? -a : a);
      break;
    case UnaryOperator::kToInt:
      *target = AsInt(a / kRawOne);
      break;
    case UnaryOperator::kToDouble:
      *target = WrapDouble(__int128{a} * kRawOne);
      break;
  }
  return true;
}

bool ReferenceMachine::StepBinary(Thread& thread, const Instruction& instruction) {
  int64_t a = 0;
  int64_t b = 0;
  if (!Load(thread, instruction.operands[0], instruction.type, &a)) return false;
  if (!Load(thread, instruction.operands[1], instruction.type, &b)) return false;
  int64_t* const target = Place(thread, instruction.operands[2]);
  if (target == nullptr) return false;
  const auto op = static_cast<BinaryOperator>(instruction.op);
  if (b == 0 && (op == BinaryOperator::kDivide || op == BinaryOperator::kRemainder)) {
    FaultAt(thread, kDivisionByZero, 0, 0);
    return false;
  }
  if (instruction.type == DataType::kInt) {
    *target = IntResult(op, a, b);
    return true;
  }
  switch (op) {
    case BinaryOperator::kAdd:
      *target = WrapDouble(__int128{a} + b);
      break;
    case BinaryOperator::kSubtract:
      *target = WrapDouble(__int128{a} - b);
      break;
    case BinaryOperator::kMultiply:
      *target = WrapDouble(__int128{a} * b / kRawOne);
      break;
    case BinaryOperator::kDivide:
      *target = WrapDouble(__int128{a} * kRawOne / b);
      break;
    default:  // the comparisons are the same for all numbers
      *target = IntResult(op, a, b);
      break;
  }
  return true;
}

bool ReferenceMachine::StepReturn(Thread& thread, const Instruction& instruction) {
  int64_t condition = 0;
  Load(thread, instruction.operands[0], DataType::kInt, &condition);
  if (condition == 0) return true;
  const DataType type = object_.functions[thread.function].return_type;
  int64_t value = 0;
  if (!Load(thread, instruction.operands[1], type, &value)) return false;
  thread.result = value;
  thread.run = Run::kStopped;
  return false;
}

bool ReferenceMachine::StepCommand(Thread& thread, const Instruction& instruction) {
  const auto& operands = instruction.operands;
  // All operands are located before anything is changed.
  std::array<int64_t*, 3> places{};
  std::array<int64_t, 3> values{};
  for (size_t i = 0; i < operands.size(); ++i) {
    if (!std::holds_alternative<Immediate>(operands[i])) {
      places[i] = Place(thread, operands[i]);
      if (places[i] == nullptr) return false;
    }
    Load(thread, operands[i], DataType::kInt, &values[i]);
  }
  thread.error = 0;
  switch (instruction.op) {
    case kDelay:
      thread.wake_cycle = cycle_ + values[0];
      break;
    case kWaitFor:
      thread.waiting = true;
      thread.wait_slot = places[0];
      thread.wait_value = static_cast<int32_t>(values[1]);
      break;
    case kUsePage: {
      bool taken = false;
      for (const Thread& other : threads) {
        taken = taken || (&other != &thread && other.run != Run::kUnbound &&
                          static_cast<int64_t>(other.page) == values[0]);
      }
      if (values[0] < 0 || values[0] > 31) {
        thread.error = 7;
      } else if (taken) {
        thread.error = 1;
      } else {
        thread.page = static_cast<size_t>(values[0]);
      }
      break;
    }
    case kAddToEach: {
      int64_t storage = 0;
      if (const auto* variable = std::get_if<Variable>(&operands[0])) {
        storage = 1024 - variable->id;
      } else {
        const auto& element = std::get<Element>(operands[0]);
        const int64_t* begin =
            element.storage == Storage::kGlobal ? globals.data() : pages[thread.page].data();
        storage = element.base + element.size - (places[0] - begin);
      }
      if (values[1] > storage) {
        FaultAt(thread, kOutputBeyondStorage, values[1], storage);
        return false;
      }
      if (values[1] < 0) thread.error = 7;
      for (int64_t i = 0; i < values[1]; ++i) {
        places[0][i] = AsInt(AsInt(places[0][i]) + values[2]);
      }
      break;
    }
    case kHalve:
      *places[0] /= 2;
      break;
    case kRefuse:
      thread.error = kRefuseCode;
      break;
    default:
      break;
  }
  if (Awake(thread)) {
    thread.waiting = false;
    thread.wake_cycle = 0;
  }
  return true;
}

// --- Comparison ----------------------------------------------------------------------------------

std::string ReferenceMachine::Difference(const Machine& machine) const {
  const MachineState& state = machine.state();
  if (state.executed != executed_) {
    return fmt::format("{} statements, reference {}", state.executed, executed_);
  }
  for (size_t i = 0; i < threads.size(); ++i) {
    const ThreadState& found = state.threads[i];
    const Thread& expected = threads[i];
    const auto differs = [&](const char* what, int64_t value, int64_t reference) {
      return fmt::format("thread {}: {} {}, reference {}", i, what, value, reference);
    };
#define COMPARE(member)                                                              \
  if (static_cast<int64_t>(found.member) != static_cast<int64_t>(expected.member)) { \
    return differs(#member, static_cast<int64_t>(found.member),                      \
                   static_cast<int64_t>(expected.member));                           \
  }
    COMPARE(run)
    COMPARE(executed)
    COMPARE(pc)
    COMPARE(error)
    COMPARE(result)
    COMPARE(page)
    COMPARE(started)
    COMPARE(fault_value)
    COMPARE(fault_limit)
    COMPARE(wake_cycle)
    COMPARE(waiting)
#undef COMPARE
  }
  for (size_t id = 0; id < globals.size(); ++id) {
    if (state.globals[id] == globals[id]) continue;
    return fmt::format("global {}: {}, reference {}", id, state.globals[id], globals[id]);
  }
  for (size_t page = 0; page < pages.size(); ++page) {
    if (state.pages[page] == pages[page]) continue;
    for (size_t id = 0; id < 1024; ++id) {
      if (state.pages[page][id] == pages[page][id]) continue;
      return fmt::format("page {} slot {}: {}, reference {}", page, id, state.pages[page][id],
                         pages[page][id]);
    }
  }
  return "";
}

}  // namespace oncard::vm
