// Tested by tests/vm/object_writer_test.cc; docs/object-format.md describes the bytes.
#include "vm/object_writer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

#include "vm/record.h"

namespace oncard::vm {
namespace {

void AppendWord(uint16_t word, std::string* bin) {
  bin->push_back(static_cast<char>(word & 0xFF));
  bin->push_back(static_cast<char>(word >> 8));
}

std::string WriteBin(const Object& object) {
  std::string bin;
  uint16_t id = 0;
  for (const Function& function : object.functions) {
    AppendWord(++id, &bin);
    AppendWord(static_cast<uint16_t>(function.return_type), &bin);
    AppendWord(static_cast<uint16_t>(function.instructions.size()), &bin);
    for (const Instruction& instruction : function.instructions) {
      for (const uint16_t word : EncodeRecord(instruction)) AppendWord(word, &bin);
    }
  }
  return bin;
}

void WriteSymbols(const std::vector<Symbol>& symbols, std::string* ini) {
  auto out = std::back_inserter(*ini);
  for (const Symbol& symbol : symbols) {
    const int type = static_cast<int>(symbol.type);
    if (symbol.array_size == 0) {
      fmt::format_to(out, "{}={},{}\n", symbol.name, symbol.id, type);
    } else {
      fmt::format_to(out, "{}[{}]={},{}\n", symbol.name, symbol.array_size, symbol.id, type);
    }
  }
}

std::string WriteVendorSections(const Object& object) {
  std::string ini = "[function]\n";
  auto out = std::back_inserter(ini);
  int id = 0;
  for (const Function& function : object.functions) {
    fmt::format_to(out, "{}={},{},{}\n", function.name, ++id, function.file,
                   static_cast<int>(function.return_type));
  }
  ini += "[global]\n";
  WriteSymbols(object.globals, &ini);
  for (const Function& function : object.functions) {
    fmt::format_to(out, "[{}.line]\n", function.name);
    for (size_t i = 0; i < function.lines.size(); ++i) {
      fmt::format_to(out, "{}={}\n", i, function.lines[i]);
    }
    fmt::format_to(out, "[{}.var]\n", function.name);
    WriteSymbols(function.variables, &ini);
  }
  return ini;
}

// What structured C calls the symbols, where that is another name; without such no section.
void WriteNames(std::string_view section, const std::vector<Symbol>& symbols, std::string* ini) {
  bool begun = false;
  for (const Symbol& symbol : symbols) {
    if (symbol.written.empty()) continue;
    if (!std::exchange(begun, true)) *ini += fmt::format("[{}]\n", section);
    *ini += fmt::format("{}={}\n", symbol.name, symbol.written);
  }
}

/// The polynomial of ITU-T V.42, reflected.
constexpr uint32_t kChecksumPolynomial = 0xEDB88320;

/// The remainder of each byte.
constexpr std::array<uint32_t, 256> kRemainders = [] {
  std::array<uint32_t, 256> remainders{};
  for (uint32_t byte = 0; byte < remainders.size(); ++byte) {
    uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit) {
      remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? kChecksumPolynomial : 0);
    }
    remainders[byte] = remainder;
  }
  return remainders;
}();

}  // namespace

uint32_t BinChecksum(std::string_view bin) {
  uint32_t remainder = ~uint32_t{0};
  for (const char byte : bin) {
    remainder = (remainder >> 8) ^ kRemainders[(remainder ^ static_cast<uint8_t>(byte)) & 0xFF];
  }
  return ~remainder;
}

std::string_view DoubleFormatName(DoubleFormat format) {
  return format == DoubleFormat::k32_16 ? "32.16" : "16.16";
}

ObjectFiles WriteObject(const Object& object, bool vendor_format) {
  ObjectFiles files{WriteBin(object), WriteVendorSections(object)};
  if (!vendor_format) {
    fmt::format_to(std::back_inserter(files.ini),
                   "[oncard]\nformat={}\ndouble={}\nbin_crc32={:08x}\n", kObjectFormat,
                   DoubleFormatName(object.double_format), BinChecksum(files.bin));
    WriteNames("names", object.globals, &files.ini);
    for (const Function& function : object.functions) {
      WriteNames(function.name + ".names", function.variables, &files.ini);
    }
  }
  return files;
}

}  // namespace oncard::vm
