// Writes docs/object-format.md with the table of opcodes and operators generated from opcodes.def.
// The rest of the document is copied unchanged.
#include <fmt/core.h>

#include <cctype>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "vm/opcodes.h"

namespace oncard::vm {
namespace {

constexpr std::string_view kBegin = "<!-- begin opcodes -->\n";
constexpr std::string_view kEnd = "<!-- end opcodes -->\n";

std::string_view Spell(OperandTypes types) {
  switch (types) {
    case OperandTypes::kInt:
      return "int";
    case OperandTypes::kDouble:
      return "double";
    case OperandTypes::kBoth:
      break;
  }
  return "int or double";
}

std::string_view Spell(ResultType result) {
  switch (result) {
    case ResultType::kInt:
      return "int";
    case ResultType::kDouble:
      return "double";
    case ResultType::kSame:
      break;
  }
  return "same";
}

// "jump" for kJump.
std::string LowerName(std::string_view constant) {
  std::string name;
  for (const char c : constant.substr(1)) {
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

// A bar would end the table cell, even inside code.
std::string Code(std::string_view spelling) {
  if (spelling.empty()) return {};
  std::string code = "`";
  for (const char c : spelling) {
    if (c == '|') code += '\\';
    code += c;
  }
  return code + '`';
}

std::string Row(std::initializer_list<std::string_view> cells) {
  std::string row = "|";
  for (const std::string_view cell : cells) {
    row += cell.empty() ? " |" : fmt::format(" {} |", cell);
  }
  return row + '\n';
}

std::string Table() {
  std::string table = Row({"number", "spelling", "operands", "result", "effect", "basis"});
  table += "|---|---|---|---|---|---|\n";
#define INSTRUCTION(name, number, basis, operands, effect) \
  table += Row({fmt::format("0x{:04X}", number), LowerName(#name), operands, "", effect, #basis});
#define UNARY_OPERATOR(name, number, basis, spelling, types, result, effect)                 \
  table += Row({fmt::format("unary {}", number), Code(spelling), Spell(OperandTypes::types), \
                Spell(ResultType::result), effect, #basis});
#define BINARY_OPERATOR(name, number, basis, spelling, precedence, types, result, effect) \
  table += Row({fmt::format("binary 0x{:02X}", number), Code(spelling),                   \
                Spell(OperandTypes::types), Spell(ResultType::result), effect, #basis});
#include "vm/opcodes.def"
  return table;
}

int Main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: generate_opcode_tables DOCUMENT OUTPUT\n");
    return 2;
  }
  auto read = ReadFile(argv[1]);
  if (!read.ok()) {
    fmt::print(stderr, "generate_opcode_tables: {}\n", read.error().message.en);
    return 1;
  }
  std::string document = std::move(read).value();
  const size_t begin = document.find(kBegin);
  const size_t end = document.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    fmt::print(stderr, "generate_opcode_tables: {} has no place for the table\n", argv[1]);
    return 1;
  }
  const size_t first = begin + kBegin.size();
  document.replace(first, end - first, Table());
  if (auto written = WriteFileAtomically(argv[2], document); !written.ok()) {
    fmt::print(stderr, "generate_opcode_tables: {}\n", written.error().message.en);
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace oncard::vm

int main(int argc, char** argv) { return oncard::vm::Main(argc, argv); }
