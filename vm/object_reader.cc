// The `.ini` is split into sections first, because the functions are listed in one of them; then
// the `.bin` is decoded with the functions that the `.ini` names. Both are read strictly: anything
// that a compiler would not write is treated as damage. The `.ini` is tokenized here because inih
// does not detect duplicate or empty sections, cuts names and lines at fixed lengths, ends at a
// NUL, and treats `:` and `;` in file names as syntax.
// Tested by tests/vm/object_reader_test.cc and tests/vm/corruption_test.cc.
#include "vm/object_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/number.h"
#include "vm/limits.h"
#include "vm/object_error.h"
#include "vm/object_writer.h"
#include "vm/record.h"
#include "vm/symbol_names.h"

namespace oncard::vm {
namespace {

constexpr std::string_view kBinEnding = ".bin";
constexpr std::string_view kIniEnding = ".ini";
constexpr size_t kBytesPerWord = 2;
// Words of a function before its records.
constexpr size_t kHeaderWords = 3;

struct Entry {
  std::string_view key;
  std::string_view value;
  size_t line = 0;
};

struct Section {
  size_t line = 0;
  std::vector<Entry> entries;
};

using Sections = std::map<std::string_view, Section>;

Message IniPlace(size_t line) {
  return MakeMessage("line {0} of the .ini", ".ini 第 {0} 行", line);
}

template <typename... Args>
Error IniError(size_t line, std::string_view en, std::string_view zh, const Args&... args) {
  return At(IniPlace(line), DamagedObject(en, zh, args...));
}

Error FunctionCountError() {
  return MakeError(kTooManyFunctions, "the program has more than {0} functions",
                   "程序的函数超过 {0} 个", kFunctionMax);
}

// A decimal number without sign or leading zeros.
std::optional<uint16_t> ParseNumber(std::string_view text) {
  if (text.size() > 1 && text.front() == '0') return std::nullopt;
  return ReadWhole<uint16_t>(text);
}

// --- Splitting the .ini --------------------------------------------------------------------------

bool HasControlCharacter(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; });
}

// Lines end with LF or CR LF; empty lines are ignored.
Result<Sections> SplitIni(std::string_view ini) {
  Sections sections;
  Section* section = nullptr;
  std::set<std::string_view> keys;
  for (size_t number = 1; !ini.empty(); ++number) {
    const size_t end = ini.find('\n');
    std::string_view line = ini.substr(0, end);
    ini.remove_prefix(end == std::string_view::npos ? ini.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    if (HasControlCharacter(line)) {
      return IniError(number, "control characters in '{0}'", "“{0}”含有控制字符", Printable(line));
    }
    if (line.starts_with('[') && line.ends_with(']')) {
      const std::string_view name = line.substr(1, line.size() - 2);
      const auto [position, inserted] = sections.try_emplace(name, Section{number, {}});
      if (!inserted) {
        return IniError(number, "section '{0}' is repeated; the first one is in line {1}",
                        "节“{0}”重复；第一次在第 {1} 行", Printable(name), position->second.line);
      }
      section = &position->second;
      keys.clear();
      continue;
    }
    const size_t separator = line.find('=');
    if (section == nullptr || separator == std::string_view::npos) {
      return IniError(number, "'{0}' is neither a section nor one of its 'name=value' lines",
                      "“{0}”既不是节，也不是节内的“名=值”行", Printable(line));
    }
    const Entry entry{line.substr(0, separator), line.substr(separator + 1), number};
    if (!keys.insert(entry.key).second) {
      return IniError(number, "'{0}' occurs twice in its section", "“{0}”在同一节中重复",
                      Printable(entry.key));
    }
    section->entries.push_back(entry);
  }
  return sections;
}

// Removes a section and returns it; sections that remain in the end are not permitted.
std::optional<Section> TakeSection(const std::string& name, Sections* sections) {
  auto node = sections->extract(std::string_view(name));
  if (node.empty()) return std::nullopt;
  return std::move(node.mapped());
}

// --- Meaning of the .ini -------------------------------------------------------------------------

// [oncard]: exactly the three lines that the writer writes, in any order.
Result<DoubleFormat> ReadOncardSection(const Section& section, std::string_view bin) {
  const std::string expected_format = fmt::format("{}", kObjectFormat);
  const std::string expected_checksum = fmt::format("{:08x}", BinChecksum(bin));
  std::optional<DoubleFormat> double_format;
  int known = 0;
  for (const Entry& entry : section.entries) {
    if (entry.key == "format") {
      if (entry.value != expected_format) {
        return IniError(entry.line, "object format '{0}' is not known; {1} is expected",
                        "未知的目标文件格式“{0}”；应为 {1}", Printable(entry.value),
                        expected_format);
      }
    } else if (entry.key == "double") {
      for (const DoubleFormat format : {DoubleFormat::k32_16, DoubleFormat::k16_16}) {
        if (entry.value == DoubleFormatName(format)) double_format = format;
      }
      if (!double_format) {
        return IniError(entry.line, "double format '{0}' is not known; 32.16 or 16.16 is expected",
                        "未知的 double 格式“{0}”；应为 32.16 或 16.16", Printable(entry.value));
      }
    } else if (entry.key == "bin_crc32") {
      if (entry.value != expected_checksum) {
        return IniError(
            entry.line,
            "checksum '{0}' expected, the .bin has {1}: it is damaged or belongs to "
            "another .ini; compile the program again",
            "应有校验和“{0}”，而 .bin 的校验和为 {1}：文件损坏或两个文件不配套；请重新编译程序",
            Printable(entry.value), expected_checksum);
      }
    } else {
      return IniError(entry.line, "'{0}' is not known in section 'oncard'", "节“oncard”中没有“{0}”",
                      Printable(entry.key));
    }
    ++known;
  }
  if (known != 3) {
    return IniError(section.line,
                    "section 'oncard' is not complete; format, double and bin_crc32 are expected",
                    "节“oncard”不完整；应有 format、double 和 bin_crc32");
  }
  return *double_format;
}

// `name=id,file,returnType`; ids count from 1. A file name may contain commas.
Result<std::vector<Function>> ReadFunctionSection(const Section& section) {
  std::vector<Function> functions;
  if (section.entries.size() > kFunctionMax) return FunctionCountError();
  for (const Entry& entry : section.entries) {
    const size_t first = entry.value.find(',');
    const size_t last = entry.value.rfind(',');
    if (first == last) {
      return IniError(entry.line, "'{0}' is not of the form id,file,returnType",
                      "“{0}”不是“标识,文件,返回类型”的形式", Printable(entry.value));
    }
    const auto id = ParseNumber(entry.value.substr(0, first));
    if (id != functions.size() + 1) {
      return IniError(entry.line, "function '{0}' has id '{1}'; {2} is expected",
                      "函数“{0}”的标识为“{1}”；应为 {2}", Printable(entry.key),
                      Printable(entry.value.substr(0, first)), functions.size() + 1);
    }
    const auto type = ParseNumber(entry.value.substr(last + 1));
    if (!type || *type > static_cast<uint16_t>(DataType::kDouble)) {
      return IniError(entry.line, "return type '{0}' is not known; 0, 1 or 2 is expected",
                      "未知的返回类型“{0}”；应为 0、1 或 2",
                      Printable(entry.value.substr(last + 1)));
    }
    Function function;
    function.name = entry.key;
    function.file = entry.value.substr(first + 1, last - first - 1);
    function.return_type = static_cast<DataType>(*type);
    functions.push_back(std::move(function));
  }
  return functions;
}

// `name=id,dataType` or `name[size]=id,dataType`.
Result<std::vector<Symbol>> ReadSymbols(const std::optional<Section>& section) {
  std::vector<Symbol> symbols;
  if (!section) return symbols;
  for (const Entry& entry : section->entries) {
    Symbol symbol;
    const size_t bracket = entry.key.find('[');
    if (bracket != std::string_view::npos) {
      const auto size =
          entry.key.ends_with(']')
              ? ParseNumber(entry.key.substr(bracket + 1, entry.key.size() - bracket - 2))
              : std::nullopt;
      if (!size || *size < 1 || *size > kSlotCount) {
        return IniError(entry.line, "'{0}' is not an array of 1 to {1} elements",
                        "“{0}”不是有 1 到 {1} 个元素的数组", Printable(entry.key), kSlotCount);
      }
      symbol.array_size = *size;
    }
    symbol.name = entry.key.substr(0, bracket);
    const size_t comma = entry.value.find(',');
    const auto id = ParseNumber(entry.value.substr(0, comma));
    const auto type =
        comma == std::string_view::npos ? std::nullopt : ParseNumber(entry.value.substr(comma + 1));
    if (!id || !type) {
      return IniError(entry.line, "'{0}' is not of the form id,dataType",
                      "“{0}”不是“标识,数据类型”的形式", Printable(entry.value));
    }
    symbol.id = *id;
    symbol.type = static_cast<DataType>(*type);
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}

// `index=sourceLine`, one per instruction in order.
Result<std::vector<uint16_t>> ReadLines(const std::optional<Section>& section) {
  std::vector<uint16_t> lines;
  if (!section) return lines;
  for (const Entry& entry : section->entries) {
    const auto index = ParseNumber(entry.key);
    const auto line = ParseNumber(entry.value);
    if (index != lines.size() || !line) {
      return IniError(entry.line, "'{0}={1}' is not the source line of instruction {2}",
                      "“{0}={1}”不是指令 {2} 的源程序行号", Printable(entry.key),
                      Printable(entry.value), lines.size());
    }
    lines.push_back(*line);
  }
  return lines;
}

// `name=written`, of symbols that the section of the variables has.
Result<void> ReadNames(const std::optional<Section>& section, std::vector<Symbol>* symbols) {
  if (!section) return {};
  std::map<std::string_view, Symbol*> by_name;
  for (Symbol& symbol : *symbols) by_name.emplace(symbol.name, &symbol);
  std::set<std::string_view> taken;
  for (const Entry& entry : section->entries) {
    const auto found = by_name.find(entry.key);
    if (found == by_name.end()) {
      return IniError(entry.line, "there is no variable '{0}'", "没有变量“{0}”",
                      Printable(entry.key));
    }
    found->second->written = entry.value;
    if (!IsWrittenName(*found->second) || !taken.insert(entry.value).second) {
      return IniError(entry.line, "'{0}' cannot be what C calls '{1}'",
                      "“{0}”不能是“{1}”在 C 中的名称", Printable(entry.value),
                      Printable(entry.key));
    }
  }
  return {};
}

// Everything but the instructions.
Result<Object> ReadIni(const ObjectFiles& files) {
  std::string_view ini = files.ini;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (ini.starts_with(kByteOrderMark)) ini.remove_prefix(kByteOrderMark.size());
  Result<Sections> split = SplitIni(ini);
  if (!split.ok()) return split.error();
  Sections sections = std::move(split).value();

  Object object;
  const std::optional<Section> function_section = TakeSection("function", &sections);
  if (!function_section) {
    return DamagedObject("the .ini has no section 'function'", ".ini 中没有节“function”");
  }
  Result<std::vector<Function>> functions = ReadFunctionSection(*function_section);
  if (!functions.ok()) return functions.error();
  object.functions = std::move(functions).value();

  Result<std::vector<Symbol>> globals = ReadSymbols(TakeSection("global", &sections));
  if (!globals.ok()) return globals.error();
  object.globals = std::move(globals).value();

  for (Function& function : object.functions) {
    Result<std::vector<uint16_t>> lines =
        ReadLines(TakeSection(function.name + ".line", &sections));
    if (!lines.ok()) return lines.error();
    function.lines = std::move(lines).value();
    Result<std::vector<Symbol>> variables =
        ReadSymbols(TakeSection(function.name + ".var", &sections));
    if (!variables.ok()) return variables.error();
    function.variables = std::move(variables).value();
  }

  if (const std::optional<Section> oncard = TakeSection("oncard", &sections)) {
    Result<DoubleFormat> format = ReadOncardSection(*oncard, files.bin);
    if (!format.ok()) return format.error();
    object.double_format = format.value();
    Result<void> names = ReadNames(TakeSection("names", &sections), &object.globals);
    for (Function& function : object.functions) {
      if (!names.ok()) break;
      names = ReadNames(TakeSection(function.name + ".names", &sections), &function.variables);
    }
    if (!names.ok()) return names.error();
  }
  if (!sections.empty()) {
    const auto& [name, section] = *sections.begin();
    return IniError(section.line, "section '{0}' belongs to no function", "节“{0}”不属于任何函数",
                    Printable(name));
  }
  return object;
}

// --- The .bin ------------------------------------------------------------------------------------

Message FunctionPlace(size_t index, const Function& function) {
  return MakeMessage("function {0} '{1}'", "函数 {0}“{1}”", index + 1, Printable(function.name));
}

// Decodes the function at the beginning of `words` and removes its words.
Result<void> ReadFunction(size_t index, Function* function, std::span<const uint16_t>* words) {
  if (words->size() < kHeaderWords) return DamagedObject("the .bin is truncated", ".bin 被截断");
  const uint16_t id = (*words)[0];
  const uint16_t type = (*words)[1];
  const uint16_t count = (*words)[2];
  *words = words->subspan(kHeaderWords);
  if (id != index + 1) {
    return DamagedObject("its id in the .bin is {0}", "在 .bin 中的标识为 {0}", id);
  }
  if (type != static_cast<uint16_t>(function->return_type)) {
    return DamagedObject("return type {0} in the .bin, {1} in the .ini",
                         "返回类型在 .bin 中为 {0}，在 .ini 中为 {1}", type,
                         static_cast<uint16_t>(function->return_type));
  }
  if (count > kInstructionMax) {
    return DamagedObject("{0} instructions; {1} are allowed", "有 {0} 条指令；最多允许 {1} 条",
                         count, kInstructionMax);
  }
  if (count != function->lines.size()) {
    return DamagedObject("{0} instructions in the .bin, source lines of {1} in the .ini",
                         ".bin 中有 {0} 条指令，.ini 中有 {1} 条的行号", count,
                         function->lines.size());
  }
  for (size_t i = 0; i < count; ++i) {
    Result<DecodedRecord> record = DecodeRecord(*words);
    if (!record.ok()) return At(MakeMessage("record {0}", "记录 {0}", i), record.error());
    *words = words->subspan(record.value().word_count);
    function->instructions.push_back(std::move(record).value().instruction);
  }
  return {};
}

Result<void> ReadBin(std::string_view bin, Object* object) {
  if (bin.size() % kBytesPerWord != 0) {
    return DamagedObject("the .bin has {0} bytes, which are not whole words of two",
                         ".bin 有 {0} 字节，不是双字节字的整数倍", bin.size());
  }
  std::vector<uint16_t> content;
  content.reserve(bin.size() / kBytesPerWord);
  for (size_t i = 0; i < bin.size(); i += kBytesPerWord) {
    content.push_back(static_cast<uint16_t>(static_cast<uint8_t>(bin[i]) |
                                            static_cast<uint8_t>(bin[i + 1]) << 8));
  }
  std::span<const uint16_t> words = content;
  for (size_t i = 0; i < object->functions.size(); ++i) {
    Function& function = object->functions[i];
    if (const Result<void> result = ReadFunction(i, &function, &words); !result.ok()) {
      return At(FunctionPlace(i, function), result.error());
    }
  }
  if (!words.empty()) {
    return DamagedObject("{0} words follow the last function of the .ini",
                         ".ini 的最后一个函数之后还有 {0} 个字", words.size());
  }
  return {};
}

}  // namespace

Result<Object> ReadObject(const ObjectFiles& files) {
  Result<Object> object = ReadIni(files);
  if (!object.ok()) return object;
  if (const Result<void> result = ReadBin(files.bin, &object.value()); !result.ok()) {
    return result.error();
  }
  return object;
}

std::string IniPathFor(const std::string& bin_path) {
  const size_t ending = bin_path.ends_with(kBinEnding) ? kBinEnding.size() : 0;
  return bin_path.substr(0, bin_path.size() - ending).append(kIniEnding);
}

Result<Object> ReadObjectPair(const std::string& bin_path, ObjectFiles* content) {
  if (bin_path.size() > kObjectPathMax) {
    return MakeError(kObjectNotFound, "the name '{0}' has {1} bytes; {2} are allowed",
                     "文件名“{0}”有 {1} 字节；最多允许 {2} 字节", Printable(bin_path),
                     bin_path.size(), kObjectPathMax);
  }
  if (!bin_path.ends_with(kBinEnding)) {
    return MakeError(kObjectNotFound, "the name '{0}' does not end in '.bin'",
                     "文件名“{0}”不以“.bin”结尾", bin_path);
  }
  if (!FileExists(bin_path)) {
    return MakeError(kObjectNotFound, "there is no file '{0}'; compile the program first",
                     "没有文件“{0}”；请先编译程序", bin_path);
  }
  FilePair files = ReadPair(bin_path, IniPathFor(bin_path), kObjectKind);
  for (const Result<std::string>* file : {&files.first, &files.second}) {
    if (!file->ok()) return Error{kObjectDamaged, file->error().message};
  }
  const ObjectFiles bytes = {std::move(files.first).value(), std::move(files.second).value()};
  if (content != nullptr) *content = bytes;
  Result<Object> object = ReadObject(bytes);
  if (!object.ok()) return At({bin_path, bin_path}, object.error());
  return object;
}

}  // namespace oncard::vm
