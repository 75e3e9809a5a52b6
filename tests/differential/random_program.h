// Random motion programs as source text, for comparison with another implementation.
//
// A program is built statement by statement, so that the text can be executed in two ways: as a
// motion program, and inside C++ (oracle.h). Everything is derived from the seed. Every program
// ends: loops have their own counter, all other jumps are forward. Indices stay in range; divisors
// are usually, but not always, different from 0.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "vm/fixed_point.h"
#include "vm/opcodes.h"

namespace oncard::differential {

/// One declared variable; a structure is one declaration with members.
struct Declaration {
  struct Slot {
    std::string name;    ///< in statements: `g1`, `a[3]`, `s.acc`
    std::string symbol;  ///< in the object: `g1`, `a`, `s.acc`
    int element = 0;
    vm::DataType type = vm::DataType::kInt;
    int64_t initial = 0;  ///< an int, or a raw fixed-point number
  };
  std::string text;  ///< `int g1`, `double a[9]`, `TPid s`
  std::vector<Slot> slots;
};

struct Statement {
  enum class Kind { kAssign, kGoto, kIfGoto, kReturn, kIfReturn, kEmpty };
  Kind kind = Kind::kAssign;
  std::vector<std::string> labels;
  std::string text;       ///< kAssign: the assignment
  std::string condition;  ///< kIfGoto, kIfReturn: the variable
  std::string target;     ///< kGoto, kIfGoto: the label
  std::string value;      ///< kReturn, kIfReturn: the operand, empty for none
};

struct RandomFunction {
  std::string name;
  std::string result;  ///< spelling of the result type
  std::vector<Declaration> parameters;
  std::vector<Declaration> locals;
  std::vector<Statement> body;
};

struct RandomProgram {
  uint64_t seed = 0;
  vm::DoubleFormat format = vm::DoubleFormat::k32_16;
  std::vector<std::pair<std::string, std::string>> macros;  ///< name, body
  std::vector<Declaration> globals;
  std::vector<RandomFunction> functions;
};

/// Whether the functions will run one after the other or interleaved. Interleaved programs share
/// most of their variables, but neither loop counters nor indices that are temporarily out of
/// range.
enum class Sharing { kSequential, kInterleaved };

RandomProgram MakeProgram(uint64_t seed, Sharing sharing);

/// Placeholders in the text of a program; comments for the language.
inline constexpr char kAfterLocals[] = "/*locals*/";
inline constexpr char kBeforeEnd[] = "/*end*/";

/// The source text of a whole program.
std::string SourceText(const RandomProgram& program);

/// The text of one statement without labels, as a source line.
std::string StatementText(const Statement& statement);

}  // namespace oncard::differential
