// Every function counts n down, so that a program ends, with four calls of a function at the same
// time at most, half of which the compiler finds out. What a call may change stands in no
// expression beside it, so that no order of operands matters.
#include "recursive_program.h"

#include <fmt/core.h>

#include <utility>

#include "random_choices.h"

namespace oncard::differential {
namespace {

class Generator : RandomChoices {
 public:
  explicit Generator(uint64_t seed) : RandomChoices(seed) { program_.seed = seed; }

  StructuredProgram Make() {
    std::string& text = program_.text;
    seen_ = Between(0, 1) == 0;
    if (!seen_) text = "//@ depth: 4\n\n";
    text +=
        "struct pair {\n  int x;\n  short y[2];\n};\n"
        "int g0, g1, g2;\nint a[8] = {3, -1, 4, 1};\n";
    program_.globals = {"g0", "g1", "g2"};
    for (int i = 0; i < 8; ++i) program_.globals.push_back(fmt::format("a[{}]", i));
    functions_ = Between(1, 3);
    for (int i = 0; i < functions_; ++i) text += Header(i) + ";\n";
    text += "static struct pair walk(int n, struct pair p, int k);\n";
    for (int i = 0; i < functions_; ++i) text += Function(i);
    text += Pairs();
    text +=
        "int f() {\n  int x = 5, y = 2, m[8] = {1, 7, 2}, w = 1;\n"
        "  struct pair p = {4, {9, -2}};\n";
    for (int i = Between(2, 3); i > 0; --i) text += Outer();
    text += "  p = walk(3, p, w);\n  g2 += p.x - p.y[0] * 3 + p.y[1];\n";
    text += "  return x ^ y ^ w ^ m[0] ^ m[1] ^ m[2] ^ m[5];\n}\n";
    return std::move(program_);
  }

 private:
  static std::string Header(int number) {
    return fmt::format("static int c{}(int n, int x, {}y, int *v, struct pair p, int *s)", number,
                       number == 1 ? "char " : "int ");
  }

  std::string Function(int number) {
    std::string text = Header(number) + " {\n  int z = x + n, t = y;\n  struct pair own = p;\n";
    const bool list = Between(0, 1) == 0;
    if (list) text += "  int w[3] = {x, n, y ^ 1};\n";
    const bool trap = Between(0, 2) == 0;
    if (trap) text += "  TTrapPrm trap = {x & 63, n, 0.5, y & 7};\n";
    text += fmt::format("  if (n <= {}) return {};\n", seen_ ? "0" : Pick({"0", "1 - (x & 1)"}),
                        Value(1));
    for (int i = Between(1, 2); i > 0; --i) {
      text += Change(list);
      if (trap) text += OfTheCard();
      text += Calls();
      if (trap) text += OfTheCard();
      text += Change(list);
    }
    std::string result = list ? Value(1) + " + w[z & 1] * w[2]" : Value(2);
    if (trap) result += " + (int)(trap.acc * 2 - trap.velStart) * trap.smoothTime";
    return text + fmt::format("  return {};\n}}\n", result);
  }

  std::string Pairs() {
    return fmt::format(
        "static struct pair walk(int n, struct pair p, int k) {{\n"
        "  struct pair q = {{k, {{p.x, n}}}};\n"
        "  if (n == 0) return p;\n"
        "  q.x = c{}(n - 1, p.x, k, a, q, &g1);\n"
        "  q = walk(n - 1, {}, k + {});\n"
        "  q.y[0] += p.y[1];\n"
        "  return {};\n"
        "}}\n",
        Between(0, functions_ - 1), Pick({"q", "p", "n & 1 ? p : q"}), Between(1, 9),
        Pick({"q", "n > 1 ? walk(n - 2, q, p.x) : q", "k & 2 ? q : p"}));
  }

  // A value of what each call has for itself.
  std::string Own() {
    return Pick({"n", "x", "y", "z", "t", "own.x", "own.y[0]", "p.y[1]", "p.x"});
  }

  std::string Value(int depth) {
    if (depth <= 0) {
      return Between(0, 4) == 0 ? std::to_string(Between(-3, 60))
                                : Pick({"z", "t", "x", "y", "n", "own.x", "own.y[1]", "p.x", "g0",
                                        "*s", "v[1]", "v[x & 3]"});
    }
    if (Between(0, 3) == 0) {
      return fmt::format("({} {} {} ? {} : {})", Own(), Pick({"<", "=="}), Value(0),
                         Value(depth - 1), Value(0));
    }
    return fmt::format("({} {} {})", Value(depth - 1), Pick({"+", "-", "*", "^", "&"}),
                       Value(depth - 1));
  }

  std::string Change(bool list) {
    switch (Between(0, list ? 6 : 5)) {
      case 0:
        return fmt::format("  own.y[n & 1] += {};\n", Own());
      case 1:
        return fmt::format("  *s += {};\n", Value(1));
      case 2:
        return fmt::format("  v[{} & 3] ^= {};\n", Own(), Value(1));
      case 3:
        return fmt::format("  if ({} > {}) own = p; else t -= {};\n", Own(), Between(0, 20),
                           Value(0));
      case 4:
        return fmt::format("  {} = {};\n", Pick({"g0", "g1", "x", "y", "z"}), Value(2));
      case 5:
        return fmt::format("  p.x -= {};\n", Value(0));
      default:
        return fmt::format("  w[{} & 1] += {};\n", Own(), Value(0));
    }
  }

  std::string OfTheCard() {
    const std::string member = Pick({"acc", "dec", "velStart", "smoothTime"});
    return Pick({fmt::format("  trap.{} += {} & 15;\n", member, Own()),
                 "  GT_SetTrapPrm(n + 1, &trap);\n", "  GT_GetTrapPrm(n & 3, &trap);\n"});
  }

  std::string Call(const std::string& first) {
    return fmt::format("c{}({}, {}, {}, {}, {}, {})", Between(0, functions_ - 1), first, Own(),
                       Own(), Pick({"v", "v", "v + 1", "a", "&v[n & 1]"}), Pick({"p", "own"}),
                       Pick({"s", "s", "&g1"}));
  }

  std::string Calls() {
    switch (Between(0, 5)) {
      case 0:
        return fmt::format("  z = {} * {} - {};\n", Own(), Own(), Call("n - 1"));
      case 1:
        return fmt::format("  for (int i = 0; i < 2; i++) z += {} ^ i;\n",
                           Call(seen_ ? "n - 1" : "n - 1 - i"));
      case 2:
        return fmt::format("  if ({} && {} > 3) t++;\n", Own(), Call("n - 1"));
      case 3:
        return fmt::format("  {};\n", Call("n - 1"));
      case 4:
        return fmt::format("  if (n & 1) return {};\n", Call("n - 1"));
      default:
        // The inner call comes first.
        return fmt::format("  z = c0(n - 1, {}, y, v, own, s);\n", Call("n - 2"));
    }
  }

  std::string Outer() {
    const std::string target = Pick({"x", "y", "g2", "w"});
    return fmt::format("  {} = {} - c{}({}, x, y, {}, p, {});\n", target, Pick({"x", "7"}),
                       Between(0, functions_ - 1), Between(1, 3),
                       Pick({"a", "m", "m + 1", "&m[x & 1]"}), Pick({"&g1", "&g0", "&w"}));
  }

  StructuredProgram program_;
  int functions_ = 1;
  bool seen_ = false;  // without a comment for the depth
};

}  // namespace

StructuredProgram MakeRecursiveProgram(uint64_t seed) { return Generator(seed).Make(); }

}  // namespace oncard::differential
