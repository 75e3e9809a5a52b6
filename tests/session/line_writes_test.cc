// What the lines of a program wrote when they were executed last.
#include "session/line_writes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/session/session_support.h"

namespace oncard::session {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::IsEmpty;

/// `0:5 a = 0`, by thread, line and values.
std::vector<std::string> Listed(const std::vector<LineWrites>& lines) {
  std::vector<std::string> list;
  for (const LineWrites& line : lines) {
    std::string text = fmt::format("{}:{}", line.thread, line.line);
    for (const auto& [name, value] : line.values) text += fmt::format(" {} = {}", name, value);
    if (!line.result.empty()) text += " -> " + line.result;
    list.push_back(std::move(text));
  }
  return list;
}

std::vector<std::string> WritesAtTheEnd(const std::string& program, const std::string& scenario,
                                        int64_t statements = 1000) {
  const auto run = RunOf(program, scenario);
  while (!run->Over()) run->Step();
  const int64_t end = run->moment();
  const uint64_t hash = run->controller().Hash();
  std::vector<std::string> list = Listed(WritesOfLines(*run, statements));
  EXPECT_EQ(run->moment(), end);
  EXPECT_EQ(run->controller().Hash(), hash);
  return list;
}

TEST(LineWrites, BelongToTheThreadAndTheLine) {
  EXPECT_THAT(
      WritesAtTheEnd(kRace, kTwoThreads),
      ElementsAre("0:5 a = 0", "1:5 a = 0", "0:6 a = 1", "1:6 a = 1", "0:7 x = 1", "1:7 x = 1"));
}

TEST(LineWrites, AreThoseOfTheLastStatements) {
  EXPECT_THAT(WritesAtTheEnd(kRace, kTwoThreads, 2), ElementsAre("0:7 x = 1", "1:7 x = 1"));
}

constexpr const char* kFills =
    "int a[3];\n"
    "int f()\n"
    "{\n"
    "  int i;\n"
    "  int more;\n"
    "  i = 0;\n"
    "next:\n"
    "  a[i] = i;\n"
    "  i = i + 1;\n"
    "  more = i < 3;\n"
    "  if (more) goto next;\n"
    "  return i;\n"
    "}\n";

TEST(LineWrites, AreTheLastOnesOfALine) {
  EXPECT_THAT(WritesAtTheEnd(kFills, ""), ElementsAre("0:6 i = 0", "0:8 a[2] = 2", "0:9 i = 3",
                                                      "0:10 more = 0", "0:11", "0:12 -> 3"));
}

TEST(LineWrites, AreThereWhereTheValueStaysTheSame) {
  EXPECT_THAT(WritesAtTheEnd("int x;\nint f()\n{\n  x = 0;\n}\n", ""), ElementsAre("0:4 x = 0"));
}

TEST(LineWrites, AreThereWhereACommandWrites) {
  const auto list = WritesAtTheEnd(
      "int value;\nint f()\n{\n  GT_SetDo(12, 5);\n  GT_GetDo(12, &value);\n}\n", "");
  EXPECT_THAT(list, Contains("0:5 value = 5"));
}

TEST(LineWrites, OfALineWithSeveralStatementsAreTogether) {
  EXPECT_THAT(WritesAtTheEnd("int x;\nint y;\nint f()\n{\n  x = 1; y = 2; x = 3;\n}\n", ""),
              ElementsAre("0:5 y = 2 x = 3"));
}

TEST(LineWrites, AreThoseBeforeThePresent) {
  const auto run = RunOf(kFills);
  for (int i = 0; i < 4; ++i) run->Step();
  EXPECT_THAT(Listed(WritesOfLines(*run, 1000)),
              ElementsAre("0:6 i = 0", "0:8 a[0] = 0", "0:9 i = 1"));
  run->GoTo(0);
  EXPECT_THAT(WritesOfLines(*run, 1000), IsEmpty());
}

TEST(LineWrites, AreThereAfterALongRest) {
  const std::string program = "int x;\nint f()\n{\n  x = 4;\n}\n";
  EXPECT_THAT(WritesAtTheEnd(program, "until_ms = 9000\n"), ElementsAre("0:4 x = 4"));
  EXPECT_THAT(WritesAtTheEnd(program, "until_ms = 11000\n"), IsEmpty());
}

TEST(LineWrites, HaveTheMomentBeforeTheirLastStatement) {
  const auto run = RunOf(kRace, kTwoThreads);
  while (!run->Over()) run->Step();
  EXPECT_THAT(WritesOfLines(*run, 1000), Contains(Field(&LineWrites::moment, 6)));
  EXPECT_EQ(WritesOfLines(*run, 1000).front().moment, 1);
}

}  // namespace
}  // namespace oncard::session
