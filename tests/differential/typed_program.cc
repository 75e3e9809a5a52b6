#include "typed_program.h"

#include <fmt/core.h>

#include <string_view>

#include "random_choices.h"

namespace oncard::differential {
namespace {

constexpr const char* kTypes[] = {"bool",  "char",           "signed char", "unsigned char",
                                  "short", "unsigned short", "int",         "unsigned int"};
constexpr int kVariables = 8;
constexpr int kDepthMax = 3;

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    text = "int g0, g1, g2, g3;\nint a[6] = {3, -1, 4}, m[2][3] = {{1, 2}, {-5}};\n";
    program_.globals = {"g0", "g1", "g2", "g3"};
    for (int i = 0; i < 6; ++i) program_.globals.push_back(fmt::format("a[{}]", i));
    // A function without calls, one that calls it, and one that works on an array.
    text += fmt::format("static {} h({} x, {} y) {{\n", Type(), Type(), Type());
    text += fmt::format("  static {} calls = {};\n  {} z = {};\n", Type(), Number(), Type(),
                        Of({"x", "y"}));
    text += fmt::format("  calls++;\n  if (x > {}) return {};\n", Of({"y", "z"}),
                        Of({"x", "y", "z", "calls"}));
    text += fmt::format("  return {};\n}}\n", Of({"x", "y", "z"}));
    text += fmt::format("static {} k({} x) {{\n  x {} 3;\n  return h(x, {}) + {};\n}}\n", Type(),
                        Type(), Pick({"+=", "*=", "-=", "^="}), Of({"x"}), Of({"x"}));
    text +=
        "static int s(int v[], int from, int n) {\n  int t = 0;\n"
        "  for (int i = from; i < n; i++) {\n    if (v[i] == 4) continue;\n    t += v[i];\n"
        "    v[i] -= i;\n    if (t > 60) return t;\n  }\n  return t;\n}\n";
    text += "int f() {\n";
    for (int i = 0; i < kVariables; ++i) {
      names_.push_back(fmt::format("v{}", i));
      text += fmt::format("  {} v{} = {};\n", Type(), i, Number());
    }
    for (int i = Between(5, 9); i > 0; --i) text += Statement();
    text += fmt::format("  g3 += {};\n  return {};\n}}\n", Expression(2), Expression(2));
    return std::move(program_);
  }

 private:
  std::string Type() { return kTypes[Between(0, static_cast<int>(std::size(kTypes)) - 1)]; }
  std::string Number() {
    return Pick({"0", "1", "-1", "7", "127", "128", "-129", "255", "300", "40000", "-40000",
                 "0x7fffffff", "0x80000000", "0xfffffff0", "5u", "'A'"});
  }

  // An expression of the given names.
  std::string Of(std::vector<std::string> names) {
    names_.swap(names);
    std::string text = Expression(2);
    names_.swap(names);
    return text;
  }

  std::string Leaf() {
    if (Between(1, 4) == 1) return Number();
    return names_[static_cast<size_t>(Between(0, static_cast<int>(names_.size()) - 1))];
  }

  std::string Expression(int depth) {
    if (depth <= 0) return Leaf();
    const auto sub = [&] { return Expression(depth - 1); };
    switch (Between(0, 9)) {
      case 0:
      case 1:
        return fmt::format("({} {} {})", sub(), Pick({"+", "-", "*", "&", "|", "^"}), sub());
      case 2:
        return fmt::format("({} {} {})", sub(), Pick({"<", "<=", ">", ">=", "==", "!="}), sub());
      case 3:  // a divisor from 1 to 8, or a large unsigned one
        return fmt::format(
            "({} {} {})", sub(), Pick({"/", "%"}),
            Pick({fmt::format("(({} & 7) + 1)", sub()), fmt::format("({} | 0x80000000)", sub())}));
      case 4:
        return fmt::format("({} {} ({} & 15))", sub(), Pick({"<<", ">>"}), sub());
      case 5:
        return fmt::format("({} {})", Pick({"-", "~", "!", "+"}), sub());
      case 6:
        return fmt::format("(({}) {})", Type(), sub());
      case 7:
        return fmt::format("({} ? {} : {})", sub(), sub(), sub());
      case 8:
        return fmt::format("({} {} {})", sub(), Pick({"&&", "||"}), sub());
      default:
        return Leaf();
    }
  }

  std::string Statement() {
    const std::string target = Pick({"v0", "v1", "v2", "v3", "v4", "v5", "g0", "g1", "g2"});
    switch (Between(0, 8)) {
      case 0:
        return fmt::format("  {} {} {};\n", target, Pick({"+=", "-=", "*=", "&=", "|=", "^="}),
                           Expression(2));
      case 1:
        return fmt::format("  {}{};\n", target, Pick({"++", "--"}));
      case 2:
        return fmt::format("  {} = h({}, {});\n", target, Expression(1), Expression(1));
      case 3:
        return fmt::format("  {} = k({}) + k({});\n", target, Expression(1), Expression(1));
      case 4:
        return fmt::format("  {} = s({}, {}, 3);\n", target, Pick({"a", "m[1]", "&a[2]"}),
                           Between(0, 2));
      case 5:
        return fmt::format(
            "  switch ({}) {{\n    case 0 ... 9: {} = 1;\n    case -7 ... -2: {}--; break;\n"
            "    default: g0++;\n  }}\n",
            Expression(2), target, target);
      case 6:
        return fmt::format("  a[{} & 3] = m[{} & 1][{} & 1] = {};\n", Expression(1), Expression(1),
                           Expression(1), Expression(2));
      case 7:
        return fmt::format("  {} = {} = {};\n", Pick({"v6", "v7"}), target, Expression(kDepthMax));
      default:
        return fmt::format("  {} = {};\n", target, Expression(kDepthMax));
    }
  }

  StructuredProgram program_;
  std::vector<std::string> names_;
};

}  // namespace

StructuredProgram MakeTypedProgram(uint64_t seed) { return Generator(seed).Make(); }

}  // namespace oncard::differential
