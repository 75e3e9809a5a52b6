// Writes docs/object-format.md with its table of opcodes and operators made from opcodes.def. The
// rest of the document stays as it is.
#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

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

// A bar ends a cell, even inside code.
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
#define BINARY_OPERATOR(name, number, basis, spelling, types, result, effect) \
  table += Row({fmt::format("binary 0x{:02X}", number), Code(spelling),       \
                Spell(OperandTypes::types), Spell(ResultType::result), effect, #basis});
#include "vm/opcodes.def"
  return table;
}

std::optional<std::string> ReadFile(const char* path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

bool WriteFile(const char* path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return file.good();
}

int Main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: generate_opcode_tables DOCUMENT OUTPUT\n");
    return 2;
  }
  std::optional<std::string> document = ReadFile(argv[1]);
  const size_t begin = document ? document->find(kBegin) : std::string::npos;
  const size_t end = document ? document->find(kEnd) : std::string::npos;
  if (begin == std::string::npos || end == std::string::npos || end < begin) {
    fmt::print(stderr, "generate_opcode_tables: {} has no place for the table\n", argv[1]);
    return 1;
  }
  const size_t first = begin + kBegin.size();
  document->replace(first, end - first, Table());
  if (!WriteFile(argv[2], *document)) {
    fmt::print(stderr, "generate_opcode_tables: cannot write {}\n", argv[2]);
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace oncard::vm

int main(int argc, char** argv) { return oncard::vm::Main(argc, argv); }
