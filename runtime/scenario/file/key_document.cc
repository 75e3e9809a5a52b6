#include "runtime/scenario/file/key_document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "base/markup.h"
#include "gtcalls/card_type.h"
#include "runtime/observe/card_warnings.h"
#include "runtime/scenario/file/key_table.h"

namespace oncard::runtime {
namespace {

constexpr std::string_view kTableEnd = "<!-- end -->\n";

std::string RangeOf(const KeyType& type) {
  if (!std::isfinite(type.largest)) return fmt::format("from {}", type.smallest);
  return fmt::format("{} to {}", type.smallest, type.largest);
}

template <typename Choices>
std::string ListOf(const Choices& choices) {
  std::vector<std::string> texts;
  texts.reserve(choices.size());
  for (const auto& choice : choices) texts.push_back(fmt::format("`{}`", choice));
  return fmt::to_string(fmt::join(texts, " "));
}

/// What a key can hold, for a cell.
std::string ValueOf(const KeyType& type) {
  switch (type.kind) {
    case KeyKind::kText:
      return "text";
    case KeyKind::kTexts:
      return "list of texts";
    case KeyKind::kChoice:
      return ListOf(type.choices);
    case KeyKind::kCard:
      return ListOf(gtcalls::CardTypeNames());
    case KeyKind::kAxes:
      return ListOf(gtcalls::AxisCounts());
    case KeyKind::kWhole:
      if (type.step == 1) return RangeOf(type);
      return fmt::format("{}, a multiple of {}", RangeOf(type), type.step);
    case KeyKind::kNumber:
      return "number, " + RangeOf(type);
    case KeyKind::kNumbers:
      return fmt::format("list of at most {} numbers, {}", type.count, RangeOf(type));
    case KeyKind::kFlag:
      return "`true` or `false`";
    case KeyKind::kTime:
      return "ms";
    case KeyKind::kTimes:
      return "list of two ms";
    case KeyKind::kLevel:
      return RangeOf(type) + ", or `any`";
    case KeyKind::kValues:
    case KeyKind::kOpenValues:
      return "table of variables";
    case KeyKind::kTable:
      return "table";
    case KeyKind::kTables:
      return "tables";
    case KeyKind::kEither:
      return "table or tables";
    case KeyKind::kWish:
      break;
  }
  return "text or table";
}

std::string TableOf(const KeySection& section) {
  std::string table = "| key | value | meaning | without it |\n|---|---|---|---|\n";
  for (const KeyDescription& key : section.keys) {
    table +=
        fmt::format("| `{}` | {} | {} | {} |\n", key.name, EscapeTableCell(ValueOf(key.type)),
                    EscapeTableCell(key.meaning.en),
                    key.required() ? std::string("required") : EscapeTableCell(key.standard.en));
  }
  return table;
}

std::string_view NameOf(KeyUse use) {
  switch (use) {
    case KeyUse::kUsed:
      return "used";
    case KeyUse::kMeansNothing:
      return "no effect";
    case KeyUse::kRefused:
      break;
  }
  return "rejected";
}

std::string TableOfUses() {
  std::string table =
      "| key | `run`, `replay`, `test` without `explore` | `explore`, `test` with `explore` | "
      "`exec` |\n|---|---|---|---|\n";
  for (const Key<Scenario>& key : ScenarioKeys()) {
    const KeyUses& uses = key.about.uses;
    table += fmt::format("| `{}` | {} | {} | {} |\n", key.about.name, NameOf(uses.run),
                         NameOf(uses.explore), NameOf(uses.host));
  }
  return table;
}

std::string TableOfWarnings() {
  std::string table = "| name | meaning |\n|---|---|\n";
  for (const CardWarningInfo& info : CardWarningTable()) {
    table += fmt::format("| `{}` | {} |\n", info.name, EscapeTableCell(info.en));
  }
  return table;
}

/// Puts a table into its place; false if there is none.
bool Replace(const std::string& title, const std::string& table, std::string* document) {
  const std::string begin = fmt::format("<!-- begin {} -->\n", title);
  size_t first = document->find(begin);
  if (first == std::string::npos) return false;
  first += begin.size();
  const size_t last = document->find(kTableEnd, first);
  if (last == std::string::npos) return false;
  document->replace(first, last - first, table);
  return true;
}

}  // namespace

Result<std::string> UpdateKeyTables(std::string document) {
  const auto replace = [&](const std::string& title, const std::string& table) -> Result<void> {
    if (Replace(title, table, &document)) return {};
    return MakeError(1, "the document has no place for the table '{0}'", "文档中没有表“{0}”的位置",
                     title);
  };
  for (const KeySection& section : KeySections()) {
    const auto done =
        replace(fmt::format("keys of {}", section.path.empty() ? "the file" : section.path),
                TableOf(section));
    if (!done.ok()) return done.error();
  }
  if (const auto done = replace("uses", TableOfUses()); !done.ok()) return done.error();
  if (const auto done = replace("warnings", TableOfWarnings()); !done.ok()) return done.error();
  return document;
}

}  // namespace oncard::runtime
