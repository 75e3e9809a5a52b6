#include "fixed_program.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "random_choices.h"

namespace oncard::differential {
namespace {

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    text =
        "int g0, g1, g2, g3;\ndouble e[4] = {1.5, -2.25, 3}, w = 0.125;\n"
        "static double mean(double x, int n, double y) {\n"
        "  double sum = x + y * n;\n  if (sum < x) return y;\n  return sum / 2;\n}\n"
        "static int eighths(double x) { return x < 0 ? -(int)(-x * 8) : (int)(x * 8); }\n";
    program_.globals = {"g0", "g1", "g2", "g3"};
    text += "int f() {\n  int i = 3, j = -5;\n";
    for (int k = 0; k < kDoubles; ++k) {
      text += fmt::format("  double d{} = {};\n", k, Number());
    }
    for (int k = Between(6, 14); k > 0; --k) text += Statement();
    for (int k = 0; k < kDoubles; ++k) text += fmt::format("  g{} += eighths(d{});\n", k % 4, k);
    text += "  for (i = 0; i < 4; i++) g0 += eighths(e[i]);\n  return eighths(w) + i + j;\n}\n";
    return std::move(program_);
  }

 private:
  static constexpr int kDoubles = 4;

  std::string Number() {
    return Pick({"0", "1", "-1", "0.5", "-0.125", "2.25", "-7.375", "100", "-300.5", "511.875"});
  }
  std::string Int() { return Pick({"i", "j", "g1", "7", "-3"}); }
  std::string SmallInt() { return fmt::format("({} % 8)", Int()); }
  std::string Place() {
    return Pick({"d0", "d1", "d2", "d3", "w", "e[i & 3]", "e[2]", "e[j & 1]"});
  }
  std::string Leaf() { return Between(0, 3) == 0 ? Number() : Place(); }

  // Of type double, a multiple of 1/64 below 2^20.
  std::string Term() {
    switch (Between(0, 7)) {
      case 0:
        return fmt::format("{} * {}", Leaf(), Place());
      case 1:
        return fmt::format("{} * {}", SmallInt(), Place());
      case 2:
        return fmt::format("{} / {}", Place(), Pick({"2", "4.0", "8", "-2.0"}));
      case 3:
        return fmt::format("fabs({})", Place());
      case 4:
        return fmt::format("(double)(int){}", Place());
      case 5:
        return fmt::format("mean({}, {}, {})", Place(), SmallInt(), Leaf());
      case 6:
        return fmt::format("-{}", Place());
      default:
        return fmt::format("1.0 * {}", Leaf());
    }
  }
  // The same below 2^21.
  std::string Sum() {
    switch (Between(0, 3)) {
      case 0:
        return fmt::format("({} ? {} : {})", Condition(), Term(), Term());
      case 1:
        return fmt::format("({} + {})", Term(), Int() == "i" ? "i" : "j % 100");
      default:
        return fmt::format("({} {} {})", Term(), Pick({"+", "-"}), Term());
    }
  }
  std::string Condition() {
    const std::string compares = Pick({"<", "<=", ">", ">=", "==", "!="});
    switch (Between(0, 4)) {
      case 0:
        return fmt::format("!{}", Place());
      case 1:
        return fmt::format("{} {} {} && {}", Leaf(), compares, Place(), Place());
      case 2:
        return fmt::format("{} {} {}", Place(), compares, SmallInt());
      default:
        return fmt::format("{} {} {}", Term(), compares, Leaf());
    }
  }
  // A sum, reduced to what a variable may hold.
  std::string Kept() { return fmt::format("(int)({} * 8) % 4096 / 8.0", Sum()); }

  std::string Statement() {
    switch (Between(0, 8)) {
      case 0:
        return fmt::format("  if ({}) {} = {};\n  else {}++;\n", Condition(), Place(), Kept(),
                           Pick({"g0", "g1", "g2"}));
      case 1:
        return fmt::format("  g2 += {};\n", Condition());
      case 2:
        return fmt::format("  i = {} % 50;\n", fmt::format("(int){}", Sum()));
      case 3: {
        const std::string place = Pick({"d0", "d1", "w"});
        return fmt::format("  {0} {1} {2};\n  {0} = (int)({0} * 8) % 4096 / 8.0;\n", place,
                           Pick({"+=", "-=", "*="}), Pick({"0.5", "2", "-1.5", "d2", "i % 4"}));
      }
      case 4:
        return fmt::format("  {} = {} = {};\n", Pick({"d2", "d3"}), Pick({"d0", "d1"}), Kept());
      case 5:
        return fmt::format(
            "  for (int k = 0; k < 3; k++) {{\n    if ({}) continue;\n    e[k] = {};\n  }}\n",
            Condition(), Kept());
      case 6:
        return fmt::format("  j -= (int){};\n  j %= 100;\n", Term());
      default:
        return fmt::format("  {} = {};\n", Place(), Kept());
    }
  }

  StructuredProgram program_;
};

}  // namespace

StructuredProgram MakeFixedProgram(uint64_t seed) { return Generator(seed).Make(); }

}  // namespace oncard::differential
