// The initial values of globals in lowered programs (compiler/lowering/start.cc): whichever threads
// begin first, none uses a global before it has its value, and none writes it again later.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "compiler/lowering/lowering.h"
#include "explore/search/explorer.h"
#include "explore_programs.h"
#include "tests/compiler/memory_files.h"

namespace oncard::explore {
namespace {

constexpr std::string_view kProgram = R"(
int speed = 5, first, second;
void t0() {
  first = speed;
  speed = 7;
}
void t1() { second = speed; }
)";

constexpr std::string_view kClaim = "//@ final: first == 5 && speed == 7 && second != 0\n";

std::string Lowered() {
  const compiler::Lowering lowering =
      compiler::LowerText("start.c", std::string(kProgram), {}, {}, compiler::NoFiles());
  return lowering.text.value_or("") + std::string(kClaim);
}

Verdict VerdictOn(const std::string& source) {
  auto result = Explore(ProblemOf(source), {.engine = EngineKind::kStateful});
  EXPECT_TRUE(result.ok());
  return result.value().verdict;
}

TEST(LoweredStartTest, ValuesAreThereBeforeAnyThreadUsesThem) {
  EXPECT_EQ(VerdictOn(Lowered()), Verdict::kProved);
}

// What the waiting loop is for.
TEST(LoweredStartTest, WithoutWaitingAValueIsOverwritten) {
  std::string source = Lowered();
  for (const std::string_view line : {"lbl_start_wait:\n", "  if (tmp1) goto lbl_start_wait;\n"}) {
    for (size_t at = source.find(line); at != std::string::npos; at = source.find(line)) {
      source.erase(at, line.size());
    }
  }
  EXPECT_EQ(VerdictOn(source), Verdict::kFailed);
}

}  // namespace
}  // namespace oncard::explore
