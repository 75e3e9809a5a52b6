// A call that changes a global stands alone on the right of an assignment, or in a condition, so
// that no order of operands matters.
#include "called_program.h"

#include <fmt/core.h>

#include <string_view>

#include "random_choices.h"

namespace oncard::differential {
namespace {

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    text = "int g0, g1, g2, g3;\nint a[6] = {3, -1, 4, 1}, m[6] = {2, 7};\n";
    program_.globals = {"g0", "g1", "g2", "g3"};
    for (int i = 0; i < 6; ++i) program_.globals.push_back(fmt::format("a[{}]", i));
    for (int i = 0; i < 6; ++i) program_.globals.push_back(fmt::format("m[{}]", i));
    text +=
        "static int walk(int *p, const int *end) {\n  int s = 0;\n"
        "  while (p < end) {\n    s = s * 3 + *p;\n    *p++ ^= s;\n  }\n  return s;\n}\n";
    const int functions = Between(2, 3);
    for (int i = 0; i < functions; ++i) text += Function();
    text += "int f() {\n  int x = 1, y = 2, z = 3, n = 0, w = 4;\n";
    values_ = {"x", "y", "z", "g0", "g1", "g2"};
    for (int i = Between(4, 6); i > 0; --i) text += Statement(2, "  ");
    text += fmt::format("  g3 += {};\n  return x ^ y ^ z ^ w;\n}}\n", Value(2));
    return std::move(program_);
  }

 private:
  // One that may call those before it: c0, c1, ...; its parameter v is an array of 4 at least, and
  // r a number of the caller that nothing else names in a call.
  std::string Function() {
    const int number = count_;
    values_ = {"x", "y", "t", "v[x & 3]", "g0", "g1", "*r", "*v", "*(v + (y & 3))"};
    in_function_ = true;
    std::string text =
        fmt::format("static {} c{}({} x, int y, int {}, int *r) {{\n  int z = x + y, n, t = {};\n",
                    Pick({"int", "int", "unsigned char", "short"}), number, Pick({"int", "char"}),
                    Pick({"v[]", "*v", "v[4]"}), Between(0, 9));
    if (Between(0, 2) == 0) text += "  static int calls;\n  z += ++calls;\n";
    for (int i = Between(1, 2); i > 0; --i) text += Statement(1, "  ");
    if (Between(0, 1) == 0) text += fmt::format("  if ({}) return {};\n", Value(1), Value(1));
    text += fmt::format("  for (int i = 0; i < 3; i++) {{\n    v[i] += t ^ z;\n  {}  }}\n",
                        Statement(0, "  "));
    text += fmt::format("  return {};\n}}\n", Value(2));
    in_function_ = false;
    ++count_;
    return text;
  }

  // Without effects.
  std::string Value(int depth) {
    if (depth <= 0 || Between(0, 3) == 0) {
      if (Between(0, 3) == 0) return std::to_string(Between(-3, 99));
      return values_[static_cast<size_t>(Between(0, static_cast<int>(values_.size()) - 1))];
    }
    switch (Between(0, 4)) {
      case 0:
        return fmt::format("({} {} {})", Value(depth - 1), Pick({"<", "==", ">=", "&&", "||"}),
                           Value(depth - 1));
      case 1:
        return fmt::format("({} ? {} : {})", Value(depth - 1), Value(depth - 1), Value(depth - 1));
      case 2:
        return fmt::format("({} % (({} & 7) + 1))", Value(depth - 1), Value(depth - 1));
      default:
        return fmt::format("({} {} {})", Value(depth - 1), Pick({"+", "-", "*", "&", "^"}),
                           Value(depth - 1));
    }
  }

  // A call, whose first argument may be one.
  std::string Call(int depth) {
    const std::string first = depth > 0 && Between(0, 3) == 0 ? Call(depth - 1) : Value(1);
    const std::string array = in_function_
                                  ? Pick({"v", "v", "a"})
                                  : Pick({"a", "a", "a", "m", "a + 1", "&m[2]", "&a[n & 1]"});
    // The other argument must not read what the call in the first one changes.
    return fmt::format("c{}({}, {}, {}, {})", Between(0, count_ - 1), first, Between(0, 9), array,
                       in_function_ ? Pick({"r", "&*r", "&r[0]"}) : Pick({"&w", "&w", "&g3"}));
  }

  std::string Statement(int depth, const std::string& indent) {
    const std::string target = in_function_ ? Pick({"x", "y", "z", "g0", "g1", "g2", "*r", "*v"})
                                            : Pick({"x", "y", "z", "g0", "g1", "g2"});
    const bool calls = count_ > 0 && Between(0, 3) > (in_function_ ? 2 : 0);
    if (depth <= 0 || Between(0, 2) > 0) {
      if (!calls) {
        return fmt::format("{}{} {} {};\n", indent, target, Pick({"=", "+=", "^="}), Value(2));
      }
      switch (Between(0, 5)) {
        case 5: {
          const std::string array = in_function_ ? Pick({"v", "a"}) : Pick({"a", "&m[1]"});
          return fmt::format("{0}z = walk({1}, {1} + {2});\n", indent, array, Between(0, 4));
        }
        case 4:  // with a value that waits for the call
          return fmt::format("{}z = ({} * {} {} {}) - {};\n", indent, Pick({"x", "y", "z"}),
                             Pick({"x", "y", "z"}), Pick({"+", "^"}), Between(1, 9), Call(0));
        case 0:
          return fmt::format("{}{};\n", indent, Call(1));
        case 1:
          return fmt::format("{0}if ({1} > {2}) z++; else z -= 2;\n", indent, Call(1),
                             Between(0, 50));
        case 2:
          // The order of the calls is that of `&&`.
          return fmt::format("{}z = {} && {};\n", indent, Call(0), Call(0));
        default:
          return fmt::format("{}z = {} * 3;\n", indent, Call(1));
      }
    }
    const std::string inner = indent + "  ";
    switch (Between(0, 3)) {
      case 3:  // arrays that wait for what is in between
        return fmt::format(
            "{0}{{\n{1}int k[4], l[4];\n{1}for (int i = 0; i < 4; i++) k[i] = {2}, l[i] = i ^ x;\n"
            "{3}{1}{4} += k[x & 3] - l[y & 3];\n{0}}}\n",
            indent, inner, Value(1), Statement(depth - 1, inner), target);
      case 0:
        return fmt::format("{0}if ({1}) {{\n{2}{3}{0}}} else {{\n{4}{0}}}\n", indent, Value(2),
                           Statement(depth - 1, inner), Statement(depth - 1, inner),
                           Statement(depth - 1, inner));
      case 1:
        return fmt::format("{0}for (int i = 0; i < {1}; i++) {{\n{2}{3}{0}}}\n", indent,
                           Between(1, 3), Statement(depth - 1, inner), Statement(depth - 1, inner));
      default:
        return fmt::format("{0}n = {1};\n{0}while (n-- > 0) {{\n{2}{0}}}\n", indent, Between(0, 3),
                           Statement(0, inner));
    }
  }

  StructuredProgram program_;
  std::vector<std::string> values_;
  int count_ = 0;  // functions so far
  bool in_function_ = false;
};

}  // namespace

StructuredProgram MakeCalledProgram(uint64_t seed) { return Generator(seed).Make(); }

}  // namespace oncard::differential
