// Evaluation of the PLC blocks. Tested by tests/gtcalls/plc_blocks_test.cc.
#include "gtcalls/gts/plc_blocks.h"

#include <algorithm>
#include <optional>

#include "motion/common/state_hash.h"

namespace oncard::gtcalls::gts {
namespace {

static_assert(motion::kFieldsComplete<DiBlock> && motion::kFieldsComplete<DoBlock> &&
              motion::kFieldsComplete<TimerBlock> && motion::kFieldsComplete<CounterBlock> &&
              motion::kFieldsComplete<FlankBlock> && motion::kFieldsComplete<SrffBlock> &&
              motion::kFieldsComplete<PlcBlock> && motion::kFieldsComplete<WordFunction> &&
              motion::kFieldsComplete<PlcBlocks>);

/// The machine's variables as accessed by one block.
class Variables {
 public:
  Variables(vm::Machine& machine, int thread)
      : machine_(machine),
        global_(thread == kGlobalVariables),
        page_(global_ ? uint8_t{0} : machine.thread(thread).page) {}

  bool On(int id) const { return machine_.ReadRaw(At(id)) != 0; }
  void Write(int id, bool on) { machine_.WriteRaw(At(id), on ? 1 : 0); }

 private:
  vm::SlotAddress At(int id) const {
    return {.global = global_, .page = page_, .id = static_cast<uint16_t>(id)};
  }

  vm::Machine& machine_;
  bool global_;
  uint8_t page_;
};

bool Matches(Edge edge, bool before, bool now) {
  if (before == now) return false;
  return edge == Edge::kBoth || now == (edge == Edge::kUp);
}

// --- Logic blocks: each gives the value of its variable ----------------------------------------

bool Next(TimerBlock& timer, const Variables& variables, int64_t cycle_us) {
  const bool input = variables.On(timer.input);
  if (input == timer.output) {
    timer.pending = false;
    timer.elapsed_us = 0;
    return timer.output;
  }
  if (timer.pending) timer.elapsed_us += cycle_us;
  timer.pending = true;
  const bool delayed = timer.type != (input ? TimerType::kOffDelay : TimerType::kOnDelay);
  if (!delayed || timer.elapsed_us >= timer.delay_us) {
    timer.output = input;
    timer.pending = false;
    timer.elapsed_us = 0;
  }
  return timer.output;
}

void Count(CounterBlock& counter) {
  if (counter.begin == counter.end) {
    const uint32_t step = counter.down ? ~uint32_t{0} : 1;
    counter.count = static_cast<int32_t>(static_cast<uint32_t>(counter.count) + step);
  } else if (counter.down) {
    counter.count = counter.count <= counter.begin ? counter.end : counter.count - 1;
  } else {
    counter.count = counter.count >= counter.end ? counter.begin : counter.count + 1;
  }
}

bool Next(CounterBlock& counter, const Variables& variables, int64_t) {
  const bool input = variables.On(counter.input);
  const bool edge = Matches(counter.edge, counter.last_input, input);
  counter.last_input = input;
  if (counter.reset >= 0 && variables.On(counter.reset)) {
    counter.count = counter.init;
    counter.unit_count = 0;
  } else if (edge && ++counter.unit_count >= counter.unit) {
    counter.unit_count = 0;
    Count(counter);
  }
  switch (counter.type) {
    case CounterType::kEqual:
      return counter.count == counter.target;
    case CounterType::kLessEqual:
      return counter.count <= counter.target;
    case CounterType::kGreaterEqual:
      break;
  }
  return counter.count >= counter.target;
}

bool Next(FlankBlock& flank, const Variables& variables, int64_t) {
  const bool input = variables.On(flank.input);
  const bool edge = Matches(flank.edge, flank.last_input, input);
  flank.last_input = input;
  return edge;
}

bool Next(SrffBlock& flip_flop, const Variables& variables, int64_t) {
  if (variables.On(flip_flop.reset)) {
    flip_flop.output = false;
  } else if (variables.On(flip_flop.set)) {
    flip_flop.output = true;
  }
  return flip_flop.output;
}

// --- Inputs and outputs --------------------------------------------------------------------------

bool ReadInput(const DiBlock& input, const motion::DigitalIo& io) {
  return ((io.Read(input.type) >> input.bit & 1) != 0) != input.reverse;
}

void WriteOutput(const DoBlock& output, bool on, motion::DigitalIo* io) {
  io->Write(output.type, uint32_t{1} << output.bit,
            on != output.reverse ? uint32_t{1} << output.bit : 0);
}

// --- Binding -------------------------------------------------------------------------------------

/// True if both write the same variable or the same output.
bool SameTarget(const PlcBlock& a, const PlcBlock& b) {
  const auto* output_a = std::get_if<DoBlock>(&a.function);
  const auto* output_b = std::get_if<DoBlock>(&b.function);
  if (output_a != nullptr && output_b != nullptr) {
    return output_a->type == output_b->type && output_a->bit == output_b->bit;
  }
  return output_a == nullptr && output_b == nullptr && a.thread == b.thread &&
         a.variable == b.variable;
}

}  // namespace

bool PlcBlocks::Bind(const PlcBlock& block) {
  const auto old = std::find_if(blocks.begin(), blocks.end(),
                                [&](const PlcBlock& other) { return SameTarget(block, other); });
  if (old != blocks.end()) blocks.erase(old);
  if (blocks.size() >= kPlcBlockMax) return false;
  blocks.push_back(block);
  return true;
}

void PlcBlocks::Unbind(int thread) {
  std::erase_if(blocks, [&](const PlcBlock& block) { return block.thread == thread; });
}

void PlcBlocks::Evaluate(vm::Machine& machine, motion::MotionCore& motion) {
  const auto for_each = [&](auto action) {
    for (PlcBlock& block : blocks) {
      const bool unbound = block.thread != kGlobalVariables &&
                           machine.thread(block.thread).run == vm::ThreadRun::kUnbound;
      if (!unbound) action(block, Variables(machine, block.thread));
    }
  };
  motion::DigitalIo& io = motion.digital_io();
  for_each([&](PlcBlock& block, Variables variables) {
    if (const auto* input = std::get_if<DiBlock>(&block.function)) {
      variables.Write(block.variable, ReadInput(*input, io));
    }
  });
  for_each([&](PlcBlock& block, Variables variables) {
    const auto evaluate = [&](auto& function) -> std::optional<bool> {
      if constexpr (requires { Next(function, variables, motion.config().cycle_us); }) {
        return Next(function, variables, motion.config().cycle_us);
      } else {
        return std::nullopt;
      }
    };
    if (const std::optional<bool> value = std::visit(evaluate, block.function)) {
      variables.Write(block.variable, *value);
    }
  });
  for_each([&](PlcBlock& block, Variables variables) {
    if (const auto* output = std::get_if<DoBlock>(&block.function)) {
      WriteOutput(*output, variables.On(block.variable), &io);
    }
  });
}

}  // namespace oncard::gtcalls::gts
