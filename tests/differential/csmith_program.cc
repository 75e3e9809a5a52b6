#include "csmith_program.h"

#include <fmt/core.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "base/files.h"

namespace oncard::differential {
namespace {

// A motion program has no pointers as variables, unions, bit-fields and numbers of 64 bits. Arrays,
// functions and blocks are small enough for the card.
constexpr const char* kOptions =
    "--no-pointers --no-unions --no-bitfields --no-volatiles --no-longlong --no-math64 --no-float "
    "--no-argc --no-packed-struct --max-array-dim 2 --max-array-len-per-dim 3 --max-funcs 4 "
    "--max-block-depth 3";

bool Runs(const std::string& command) {
  // NOLINTNEXTLINE(cert-env33-c): a test, calling a generator by its name
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

// The names that csmith gives to what is outside of functions.
bool IsGlobalName(std::string_view name) {
  const auto numbered = [name](std::string_view prefix) {
    return name.size() > prefix.size() && name.starts_with(prefix) &&
           std::isdigit(static_cast<unsigned char>(name[prefix.size()])) != 0;
  };
  return name == "main" || name == "__undefined" || numbered("func_") || numbered("g_") ||
         numbered("S");
}

// The program with other names of globals.
std::string WithSuffix(std::string_view text, size_t number) {
  const auto in_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::string renamed;
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && in_name(text[end])) ++end;
    if (end == at) {
      renamed += text[at++];
      continue;
    }
    const std::string_view name = text.substr(at, end - at);
    renamed += name;
    if (IsGlobalName(name)) renamed += fmt::format("_{}", number);
    at = end;
  }
  return renamed;
}

}  // namespace

bool HasCsmith() { return Runs("csmith --version"); }

Result<std::string> MakeCsmithProgram(uint64_t seed, const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  // It also writes where it is what it knows of the machine.
  if (!Runs(fmt::format("cd '{}' && csmith {} --seed {} --output program.c", folder, kOptions,
                        seed))) {
    return MakeError(1, "csmith makes no program of seed {}", "csmith 无法由种子 {} 生成程序",
                     seed);
  }
  return ReadFile(folder + "/program.c");
}

std::string CsmithOracleText(const std::string& header, const std::vector<std::string>& programs) {
  constexpr std::string_view kInclude = "#include \"csmith.h\"";
  std::string text =
      "#include <stdio.h>\n"
      "static void report(unsigned value) { printf(\"%u\\n\", value); }\n" +
      header;
  std::string calls;
  for (size_t i = 0; i < programs.size(); ++i) {
    std::string program = WithSuffix(programs[i], i);
    program.erase(program.find(kInclude), kInclude.size());
    text += program;
    calls += fmt::format("  main_{}();\n  report({});\n", i, kCsmithResult);
  }
  return text + fmt::format("int main(void) {{\n{}  return 0;\n}}\n", calls);
}

}  // namespace oncard::differential
