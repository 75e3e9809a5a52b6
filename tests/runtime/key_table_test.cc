// The rows of runtime/scenario/file/key_table.h, and the tables of the documentation that follow.
#include "runtime/scenario/file/key_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/files.h"
#include "runtime/scenario/file/key_document.h"
#include "runtime/scenario/file/keyed_toml.h"

namespace oncard::runtime {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(KeyTable, SaysInBothLanguagesWhatEachKeyMeans) {
  for (const KeySection& section : KeySections()) {
    std::set<std::string_view> names;
    for (const KeyDescription& key : section.keys) {
      EXPECT_TRUE(names.insert(key.name).second) << section.path << ": " << key.name;
      EXPECT_NE(key.meaning.en, "") << section.path << ": " << key.name;
      EXPECT_NE(key.meaning.zh, "") << section.path << ": " << key.name;
      EXPECT_EQ(key.standard.en.empty(), key.standard.zh.empty()) << key.name;
    }
  }
}

TEST(KeyTable, HasEverySectionOnce) {
  std::multiset<std::string_view> described;
  std::multiset<std::string_view> named = {""};
  for (const KeySection& section : KeySections()) {
    described.insert(section.path);
    for (const KeyDescription& key : section.keys) {
      if (!key.type.section.empty()) named.insert(key.type.section);
      if (!key.type.several.empty()) named.insert(key.type.several);
    }
  }
  EXPECT_EQ(described, named);
}

/// What a row calls its standard value, compared with that of the structure.
template <typename Structure>
void ExpectStandards(std::span<const Key<Structure>> rows) {
  for (const Key<Structure>& row : rows) {
    const auto compare = [&](auto member) {
      if constexpr (!std::is_same_v<decltype(member), std::monostate>) {
        const Structure standard = {};
        std::string value = FormatValue(row.about.type, standard.*member);
        std::string said(row.about.standard.en);
        std::erase(said, '`');
        if (row.about.type.kind == KeyKind::kChoice) said = '"' + said + '"';
        // Words such as `none` stand for what is empty.
        if (said.find_first_of("0123456789\"") == 0 && said.find(' ') == std::string::npos &&
            row.about.type.kind != KeyKind::kValues &&
            row.about.type.kind != KeyKind::kOpenValues) {
          EXPECT_EQ(value, said) << row.about.name;
        }
      }
    };
    std::visit(compare, row.member);
  }
}

TEST(KeyTable, SaysTheValuesThatTheStructuresBeginWith) {
  ExpectStandards(ScenarioKeys());
  ExpectStandards(WishKeys());
  ExpectStandards(ThreadKeys());
  ExpectStandards(HostKeys());
  ExpectStandards(PressKeys());
  ExpectStandards(InputKeys());
  ExpectStandards(MotorKeys());
  ExpectStandards(FaultKeys());
  ExpectStandards(HandKeys());
  ExpectStandards(VoltageKeys());
  ExpectStandards(ModuleKeys());
  ExpectStandards(BusSlaveKeys());
  ExpectStandards(BusInputKeys());
}

TEST(KeyTable, LeavesOutWhatHasItsStandardValue) {
  Scenario scenario;
  scenario.program = "p.c";
  EXPECT_EQ(FormatScenario(scenario),
            "program = \"p.c\"\ndouble = \"32.16\"\nschedule = \"rr\"\nrate = 100\naxes = 8\n"
            "cycle_us = 250\nlimit_ms = 60000\n");
  scenario.until_us = 1500;
  scenario.never = {"x == 1", "\"y"};
  scenario.races = "none";
  EXPECT_THAT(FormatScenario(scenario),
              HasSubstr("limit_ms = 60000\nuntil_ms = 1.5\nnever = [\"x == 1\", \"\\\"y\"]\n"
                        "races = \"none\"\n"));
}

TEST(KeyTable, WritesPeriodsAndPrioritiesOfPeriodicThreadsOnly) {
  Scenario scenario;
  scenario.threads = {{0, "f", 0, {{"n", {1}}}}, {1, "g", 3, {}, 20}};
  EXPECT_THAT(
      FormatScenario(scenario),
      HasSubstr("\n[[thread]]\nthread = 0\nfunction = \"f\"\npage = 0\ninit = { \"n\" = 1 }\n"
                "\n[[thread]]\nthread = 1\nfunction = \"g\"\npage = 3\nperiod_ms = 20\n"
                "priority = 4\n"));
}

// --- The documentation ---------------------------------------------------------------------------

std::string Page() { return ReadFile(ONCARD_SOURCE_DIR "/docs/scenarios.md").value(); }

TEST(KeyDocument, IsUpToDate) {
  const auto updated = UpdateKeyTables(Page());
  ASSERT_TRUE(updated.ok()) << updated.error().message.en;
  EXPECT_TRUE(updated.value() == Page()) << "run `cmake --build . --target update_key_tables`";
}

// Some rows as they must read, so that the generator is not its only judge.
TEST(KeyDocument, ShowsTypesRangesAndUses) {
  const std::string page = Page();
  EXPECT_THAT(page, HasSubstr("\n| `axes` | `2` `3` `4` `8` `12` | number of axes"));
  EXPECT_THAT(page, HasSubstr("\n| `races` | `any` `benign` `none` | "));
  EXPECT_THAT(page, HasSubstr("\n| `function` | text | name of the function | required |\n"));
  EXPECT_THAT(page, HasSubstr("\n| `volts` | number, -12.5 to 12.5 | "));
  EXPECT_THAT(page, HasSubstr("\n| `races` | rejected | used | rejected |\n"));
  EXPECT_THAT(page, HasSubstr("\n| `host` | used | rejected | rejected |\n"));
}

TEST(KeyDocument, NeedsAPlaceForEveryTable) {
  std::string page = Page();
  page.replace(page.find("<!-- begin keys of world.hand -->"), 10, "<!-- gone ");
  const auto updated = UpdateKeyTables(page);
  ASSERT_FALSE(updated.ok());
  EXPECT_THAT(updated.error().message.en, HasSubstr("'keys of world.hand'"));
  EXPECT_THAT(page, Not(HasSubstr("<!-- begin keys of world.hand")));
}

}  // namespace
}  // namespace oncard::runtime
