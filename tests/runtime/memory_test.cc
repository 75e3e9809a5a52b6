// The memory used by a card, counted by the allocator.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "runtime/sim/controller.h"

namespace {

std::atomic<int64_t> live_bytes = 0;

/// Each block is preceded by its size, padded to the strictest alignment.
constexpr size_t kHeader = alignof(std::max_align_t);

void* CountedAllocate(size_t size) {
  auto* block = static_cast<size_t*>(std::malloc(size + kHeader));
  if (block == nullptr) std::abort();
  *block = size;
  live_bytes += static_cast<int64_t>(size);
  return reinterpret_cast<char*>(block) + kHeader;
}

void CountedFree(void* pointer) {
  if (pointer == nullptr) return;
  auto* block = reinterpret_cast<size_t*>(static_cast<char*>(pointer) - kHeader);
  live_bytes -= static_cast<int64_t>(*block);
  std::free(block);
}

}  // namespace

void* operator new(size_t size) { return CountedAllocate(size); }
void* operator new[](size_t size) { return CountedAllocate(size); }
void* operator new(size_t size, const std::nothrow_t&) noexcept { return CountedAllocate(size); }
void* operator new[](size_t size, const std::nothrow_t&) noexcept { return CountedAllocate(size); }
void operator delete(void* pointer) noexcept { CountedFree(pointer); }
void operator delete[](void* pointer) noexcept { CountedFree(pointer); }
void operator delete(void* pointer, size_t) noexcept { CountedFree(pointer); }
void operator delete[](void* pointer, size_t) noexcept { CountedFree(pointer); }

namespace oncard::runtime {
namespace {

constexpr int64_t kMebibyte = 1024 * 1024;

/// The largest program: every function has the maximum length of a `.bin`.
vm::Object LargestProgram() {
  vm::Object object;
  object.globals.push_back({"g", 0, vm::DataType::kInt, 0});
  for (int f = 0; f < vm::kFunctionMax; ++f) {
    vm::Function function;
    function.name = fmt::format("f{}", f);
    function.file = "p.c";
    for (int i = 0; i < 1024; ++i) {
      vm::Instruction copy;
      copy.opcode = vm::Opcode::kUnary;
      copy.op = static_cast<uint16_t>(vm::UnaryOperator::kCopy);
      copy.operands = {vm::ImmediateInt(i), vm::Variable{vm::Storage::kGlobal, 0}};
      function.instructions.push_back(copy);
      function.lines.push_back(1);
    }
    object.functions.push_back(function);
  }
  return object;
}

TEST(MemoryTest, ACardTakesLessThanFourMebibytes) {
  const int64_t before = live_bytes;
  auto controller = std::make_unique<Controller>();
  EXPECT_LT(live_bytes - before, kMebibyte);
  controller.reset();
  EXPECT_EQ(live_bytes, before);
}

TEST(MemoryTest, SixteenCardsWithThirtyTwoFunctionsEachTakeLessThanFourMebibytesEach) {
  const int64_t before = live_bytes;
  std::vector<std::unique_ptr<Controller>> cards;
  for (int card = 0; card < 16; ++card) {
    cards.push_back(std::make_unique<Controller>());
    const auto loaded = cards.back()->Load(LargestProgram());
    ASSERT_TRUE(loaded.ok()) << loaded.error().message.en;
    ASSERT_EQ(cards.back()->machine().Bind(0, 1, 0), vm::kOk);
    ASSERT_EQ(cards.back()->machine().Run(0), vm::kOk);
    cards.back()->AdvanceUs(1000);
    EXPECT_LT(live_bytes - before, (card + 1) * 4 * kMebibyte);
  }
}

TEST(MemoryTest, RunningAllocatesNothing) {
  Controller controller;
  ASSERT_TRUE(controller.Load(LargestProgram()).ok());
  for (int thread = 0; thread < vm::kThreadCount; ++thread) {
    ASSERT_EQ(controller.machine().Bind(thread, thread + 1, thread), vm::kOk);
    ASSERT_EQ(controller.machine().Run(thread), vm::kOk);
  }
  const int64_t before = live_bytes;
  controller.AdvanceUs(100'000);
  EXPECT_EQ(live_bytes, before);
}

}  // namespace
}  // namespace oncard::runtime
