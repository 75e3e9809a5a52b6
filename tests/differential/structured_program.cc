// The generator follows C's rules by itself: an expression between two sequence points changes at
// most one variable and does not read it elsewhere.
#include "structured_program.h"

#include <fmt/core.h>

#include <string_view>

#include "random_choices.h"

namespace oncard::differential {
namespace {

constexpr int kArraySize = 6;
constexpr int kFuel = 60;
constexpr int kNestingMax = 3;
constexpr int kDepthMax = 3;

class Generator : RandomChoices {
 public:
  Generator(uint64_t seed, Floats floats) : RandomChoices(seed), floats_(floats) {
    program_.seed = seed;
  }

  StructuredProgram Make() {
    std::string& text = program_.text;
    text = fmt::format("#define C0 ({} {} 3)\n#define C1 2 + {}\n", Between(0, 9),
                       Pick({"*", "-", "/", "<"}), Pick({"C0", "'\\t'", "7 % 4", "true"}));
    text +=
        fmt::format("bool b0;\nint fuel, g0, g1, g2, g3;\nint a[{}], m[3][2 * 2];\n", kArraySize);
    program_.globals = {"fuel", "g0", "g1", "g2", "g3"};
    for (int i = 0; i < kArraySize; ++i) program_.globals.push_back(fmt::format("a[{}]", i));
    text += "int f() {\n  int x = " + Number() + ", y = " + Pick({"x + 1", "3", "x * x"}) + ";\n";
    text += fmt::format("  int z = y - x;\n  double d = {};\n", Float("0.5"));
    text += fmt::format("  bool b1 = {}, b2 = b1;\n", Pick({"true", "false", "x > 2", "!x"}));
    if (Chance(50))
      text += "  int t[C0 * 0 + 5] = {4, 7};\n";
    else
      text += "  int t[5] = {0, 1, 2, 3, 4};\n";
    text += fmt::format("  fuel = {};\n", kFuel);
    indent_ = 1;
    text += Statements(Between(3, 6));
    text += fmt::format("  g3 = {};\n", Pure(2, ""));
    if (uses_done_ || Chance(30)) text += "done:\n";
    text += fmt::format("  return {};\n}}\n", Pure(1, ""));
    return std::move(program_);
  }

 private:
  std::string Number() {
    if (Chance(85)) return std::to_string(Between(-3, 9));
    return Pick({"'\\a'", "'!'", "true", "false", "C0"});
  }

  std::string Float(std::string_view number) const {
    return fmt::format("{}{}", number, floats_ == Floats::kSuffixed ? "f" : "");
  }

  std::string Truth() { return Pick({"b0", "b1", "b2"}); }

  // A variable other than `except`.
  std::string Variable(std::string_view except) {
    for (;;) {
      std::string name = Pick({"x", "y", "z", "g0", "g1", "g2", "g3"});
      if (Chance(10)) name = Truth();
      if (!counters_.empty() && Chance(20)) {
        name = counters_[static_cast<size_t>(Between(0, static_cast<int>(counters_.size()) - 1))];
      }
      if (name != except) return name;
    }
  }
  std::string Target() { return Pick({"x", "y", "z", "g0", "g1", "g2", "g3"}); }

  // --- Expressions without effects -----------------------------------------------------------

  std::string Element(int depth, std::string_view except) {
    if (except == "a") return Variable(except);
    switch (Between(0, 3)) {
      case 0:
        return fmt::format("a[{}]", Between(0, kArraySize - 1));
      case 1:
        return fmt::format("t[{} & 3]", Pure(depth - 1, except));
      case 2:
        return fmt::format("m[{} & 1][{}]", Pure(depth - 1, except), Between(0, 3));
      default:
        return fmt::format("a[{} & 3]", Pure(depth - 1, except));
    }
  }

  // An operand that binds more tightly than every binary operator.
  std::string Leaf(int depth, std::string_view except) {
    if (depth > 0 && Chance(25)) return Element(depth, except);
    if (Chance(25)) return Number();
    return Variable(except);
  }

  std::string Pure(int depth, std::string_view except) {
    if (depth <= 0 || Chance(20)) return Leaf(depth, except);
    const auto sub = [&] { return Pure(depth - 1, except); };
    switch (Between(0, 12)) {
      case 0:
        return fmt::format("({} {} {})", sub(), Pick({"+", "-", "*", "&", "|", "^"}), sub());
      case 1:
        return fmt::format("({} {} {})", sub(), Pick({"<", "<=", ">", ">=", "==", "!="}), sub());
      case 2:
        return fmt::format("({} {} {})", sub(), Pick({"/", "%"}), Between(2, 9));
      case 3:
        return fmt::format("({} {} {})", sub(), Pick({"<<", ">>"}), Between(0, 5));
      case 4:
        return fmt::format("(- {})", sub());
      case 5:
        return fmt::format("(!{})", sub());
      case 6:
        return fmt::format("(~{})", sub());
      case 7:
        return fmt::format("({} ? {} : {})", PureCondition(depth - 1, except), sub(), sub());
      case 8:
        return PureCondition(depth, except);
      case 9:
        return fmt::format("({0} > 0 ? {1} {2} {0} : {3})", Variable(except), sub(),
                           Pick({"/", "%"}), sub());
      case 10:
        return fmt::format("(d {} {})", Pick({"<", ">", "<=", ">="}), Pick({"2.5", "7", "0.75"}));
      case 11:
        return fmt::format("(({} & 255) * 0.5 > d)", sub());
      default:
        return fmt::format("({} + {})", sub(), sub());
    }
  }

  // With guards: the right operand of `&&` would fault if the left one does not hold.
  std::string PureCondition(int depth, std::string_view except) {
    const std::string variable = Variable(except);
    switch (Between(0, 4)) {
      case 0:
        return except == "a"
                   ? fmt::format("({0} > 0 && {1} % {0} > 1)", variable, Pure(depth - 1, except))
                   : fmt::format("({0} >= 0 && {0} < {1} && a[{0}] > {2})", variable, kArraySize,
                                 Pure(depth - 1, except));
      case 1:
        return fmt::format("({0} > 0 && {1} / {0} > {2})", variable, Pure(depth - 1, except),
                           Number());
      case 2:
        return fmt::format("({0} < 1 || {1} % {0} == 0)", variable, Pure(depth - 1, except));
      case 3:
        return fmt::format("({} || {})", Pure(depth - 1, except), Pure(depth - 1, except));
      default:
        return fmt::format("({} && {})", Pure(depth - 1, except), Pure(depth - 1, except));
    }
  }

  // --- Expressions with effects --------------------------------------------------------------

  // Changes one variable and has a truth value.
  std::string Effect() {
    const std::string target = Target();
    const std::string other = Pure(1, target);
    switch (Between(0, 6)) {
      case 0:
        return fmt::format("{}++ {} {}", target, Pick({"<", ">", "!="}), other);
      case 1:
        return fmt::format("--{} {} {}", target, Pick({"<", ">="}), other);
      case 2:
        return fmt::format("({} = {}) {} {}", target, Pure(2, target), Pick({"<", "!="}), other);
      case 3:
        return fmt::format("({} += {}) > {}", target, Number(), other);
      case 4:
        return fmt::format("a[{} & 3]++ > {}", Pure(1, "a"), Pure(1, "a"));
      case 5:
        return fmt::format("t[{}++ & 3] > {}", target, other);
      default:
        return fmt::format("{}++", target);
    }
  }

  // A condition of `if` or a loop.
  std::string Condition(int depth) {
    if (depth <= 0) return Chance(50) ? Pure(2, "") : fmt::format("({})", Effect());
    switch (Between(0, 7)) {
      case 0:
      case 1:
        return fmt::format("{} && {}", Condition(depth - 1), Condition(depth - 1));
      case 2:
        return fmt::format("({} || {})", Condition(depth - 1), Condition(depth - 1));
      case 3:
        return fmt::format("!({})", Condition(depth - 1));
      case 4:
        return fmt::format("({} ? {} : {})", Condition(depth - 1), Condition(depth - 1),
                           Condition(depth - 1));
      case 5:
        return fmt::format("({}, {})", Effect(), Condition(depth - 1));
      case 6:
        return Effect();
      default:
        return Pure(2, "");
    }
  }

  std::string LoopCondition() {
    const std::string fuel = "fuel-- > 0";
    switch (Between(0, 3)) {
      case 0:
        return fuel;
      case 1:
        return fmt::format("{} && ({})", fuel, Condition(1));
      case 2:
        return fmt::format("({}) && {}", Condition(1), fuel);
      default:
        return fmt::format("{} && !({})", fuel, Condition(1));
    }
  }

  // --- Statements ----------------------------------------------------------------------------

  std::string Indent() const { return std::string(static_cast<size_t>(indent_) * 2, ' '); }

  std::string Simple() {
    const std::string target = Target();
    switch (Between(0, 15)) {
      case 13:
        return fmt::format("{} = {} {} {};", Truth(), Pure(1, ""), Pick({"<", "==", "&&", "||"}),
                           Pure(1, ""));
      case 14:
        return fmt::format("{} {} !{};", Truth(), Pick({"=", "|=", "&=", "^="}), Pure(1, ""));
      case 15:
        return fmt::format("{} = C1;", target);
      case 0:
        return fmt::format("{}{};", target, Pick({"++", "--"}));
      case 1:
        return fmt::format("{} {} {};", target, Pick({"+=", "-=", "*=", "&=", "|=", "^="}),
                           Pure(2, ""));
      case 2:
        return fmt::format("{} {} {};", target, Pick({"/=", "%=", ">>=", "<<="}), Between(1, 5));
      case 3:
        return fmt::format("a[{} & 3] = {};", Pure(1, ""), Pure(2, ""));
      case 4:
        return fmt::format("a[{}++ & 3] {} {};", target, Pick({"+=", "=", "^="}), Pure(1, target));
      case 5:
        return fmt::format("m[{} & 1][{} & 3] = {};", Pure(1, ""), Pure(1, ""), Pure(1, ""));
      case 6: {
        const std::string other = Target();
        if (other == target) return fmt::format("{} = {};", target, Pure(3, ""));
        return fmt::format("{} = {} = {};", target, other, Pure(2, ""));
      }
      case 7:
        return fmt::format("{} = {};", target, Condition(1));
      case 8:
        return fmt::format("d = ({} & 63) * {};", Pure(1, ""),
                           Pick({"0.25", "0.5", Float("1.5"), "2"}));
      case 9:
        return fmt::format("{} = d * {};", target, Pick({"2", "0.5", "4.0"}));
      case 10:
        return fmt::format("t[{}] = {};", Between(0, 4), Pure(2, ""));
      case 11:
        return fmt::format("{}++, {} = {};", target, Target(), Pure(1, ""));
      default:
        return fmt::format("{} = {};", target, Pure(kDepthMax, ""));
    }
  }

  std::string Statements(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += Indent() + One() + '\n';
    return text;
  }

  // The body of a loop or branch, with braces or without.
  std::string Body() {
    if (nesting_ >= kNestingMax || Chance(30)) return ' ' + Jump();
    ++nesting_;
    ++indent_;
    std::string text = " {\n";
    if (Chance(30)) text += Indent() + Declaration() + '\n';
    text += Statements(Between(1, 3));
    --indent_;
    --nesting_;
    return text + Indent() + '}';
  }

  // Declares a new name, or one that hides a local or a global until the end of the block.
  std::string Declaration() {
    if (Chance(15)) return fmt::format("bool n = !({}), k = {};", Pure(1, "n"), Truth());
    const std::string name = Pick({"n", "k", "x", "y", "g1", "g2"});
    std::string value = Pure(2, name);
    // A hidden variable is redeclared in C++ as well as in C; its own value is not read.
    return fmt::format("int {} = {};", name, value);
  }

  std::string Jump() {
    if (in_loop_ && Chance(25)) return Pick({"break;", "continue;"});
    if (Chance(5)) return fmt::format("return {};", Pure(1, ""));
    if (Chance(5)) {
      uses_done_ = true;
      return "goto done;";
    }
    return Simple();
  }

  std::string Loop() {
    const bool outer = in_loop_;
    in_loop_ = true;
    std::string text;
    switch (Between(0, 3)) {
      case 0:
        text = fmt::format("while ({}){}", LoopCondition(), Body());
        break;
      case 1:
        text = fmt::format("do{} while ({});", Body(), LoopCondition());
        break;
      case 2: {
        const std::string counter = Pick({"n", "k", "x", "g0"});
        counters_.push_back(counter);
        const std::string body = Body();
        counters_.pop_back();
        text = fmt::format("for (int {0} = {1}; {0} < {2} && fuel-- > 0; {0}++){3}", counter,
                           Between(-1, 2), Between(1, 5), body);
        break;
      }
      default: {
        const std::string target = Target();
        text = fmt::format("for ({0} = {1}; {2}; {0} {3} {4}){5}", target, Number(),
                           LoopCondition(), Pick({"+=", "-="}), Between(1, 3), Body());
        break;
      }
    }
    in_loop_ = outer;
    return text;
  }

  std::string Switch() {
    std::string text = fmt::format("switch ({} & 7) {{\n", Pure(2, ""));
    const int default_at = Between(0, 4);
    ++nesting_;
    for (int i = 0; i < 4; ++i) {
      if (i == default_at) text += Indent() + "default:\n";
      text += Indent() + fmt::format("case {}:\n", i * 2 - (i == 3 ? 1 : 0));
      ++indent_;
      text += Statements(Between(0, 2));
      if (Chance(60)) text += Indent() + "break;\n";
      --indent_;
    }
    --nesting_;
    return text + Indent() + "  " + Simple() + '\n' + Indent() + '}';
  }

  std::string One() {
    const int kind = Between(1, 100);
    if (nesting_ >= kNestingMax || kind <= 40) return Simple();
    if (kind <= 60) {
      std::string text = fmt::format("if ({}){}", Condition(2), Body());
      // Avoids a dangling else: without braces the body is a simple statement.
      if (Chance(50)) text += fmt::format(" else{}", Body());
      return text;
    }
    if (kind <= 85) return Loop();
    if (kind <= 93) return Switch();
    ++nesting_;
    ++indent_;
    std::string text = "{\n" + Indent() + Declaration() + '\n' + Statements(2);
    --indent_;
    --nesting_;
    return text + Indent() + '}';
  }

  const Floats floats_;
  StructuredProgram program_;
  int indent_ = 0;
  int nesting_ = 0;
  bool in_loop_ = false;
  bool uses_done_ = false;
  std::vector<std::string> counters_;  // counters of the enclosing loops, which may be read
};

}  // namespace

StructuredProgram MakeStructuredProgram(uint64_t seed, Floats floats) {
  return Generator(seed, floats).Make();
}

}  // namespace oncard::differential
