// Generates random motion programs. The generator keeps the results comparable: it chooses which
// variables a statement may write (not loop counters, not indices), where jumps may go, and
// literals that mean the same in the language and in C++ when two of them are operands together.
#include "random_program.h"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <utility>

#include "random_choices.h"

namespace oncard::differential {
namespace {

using vm::DataType;

// Indices are kept in 0..kIndexMask, so every array has more elements.
constexpr int kIndexMask = 7;
constexpr int kArrayMin = kIndexMask + 1;
constexpr int kLoopMax = 6;
constexpr int kNestingMax = 2;

constexpr std::array<int32_t, 14> kNotableInts = {
    0, 1, -1, 2, -2, 7, 31, 32, 33, 65535, 65536, INT32_MAX, INT32_MIN, INT32_MIN + 1};

class Generator : RandomChoices {
 public:
  Generator(uint64_t seed, Sharing sharing) : RandomChoices(seed), sharing_(sharing) {
    program_.seed = seed;
  }

  RandomProgram Make() {
    if (Chance(40)) program_.format = vm::DoubleFormat::k16_16;
    MakeMacros();
    MakeVariables("g", 2, &program_.globals, &global_);
    const int functions = interleaved() ? Between(2, 4) : (Chance(25) ? 2 : 1);
    for (int i = 0; i < functions; ++i) MakeFunction(i);
    return std::move(program_);
  }

 private:
  // The variables that statements may use. Counters and indices are among the readable ints, never
  // among the targets.
  struct Scope {
    std::vector<std::string> ints, int_targets, doubles, double_targets, indices, counters;
    std::vector<std::string> int_arrays, double_arrays;
  };

  bool interleaved() const { return sharing_ == Sharing::kInterleaved; }
  template <typename Container>
  const auto& Pick(const Container& from) {
    return from[static_cast<size_t>(Between(0, static_cast<int>(from.size()) - 1))];
  }
  // Chooses among the function's own variables and the globals, so that threads share globals.
  const std::string& Pick(std::vector<std::string> Scope::*list) {
    const auto& local = local_.*list;
    const auto& global = global_.*list;
    const bool prefer_global = Chance(interleaved() ? 60 : 30);
    return local.empty() || (prefer_global && !global.empty()) ? Pick(global) : Pick(local);
  }

  // --- Literals ----------------------------------------------------------------------------------

  int32_t AnyInt() {
    if (Chance(35)) return Pick(kNotableInts);
    if (Chance(60)) return Between(-100, 100);
    return static_cast<int32_t>(Bits());
  }

  int64_t AnyRaw() {
    const int shift = vm::WrapShift(program_.format);
    if (Chance(20)) return vm::WrapFixed(Pick(kNotableInts) * int64_t{Between(1, 3)}, shift);
    return static_cast<int64_t>(Bits()) >> (shift + (Chance(60) ? Between(8, 24) : 0));
  }

  std::string IntLiteral() {
    const int32_t value = AnyInt();
    if (Chance(25)) {
      return Chance(50) ? fmt::format("0x{:x}", static_cast<uint32_t>(value))
                        : fmt::format("0x{:X}", static_cast<uint32_t>(value));
    }
    static constexpr std::array<std::string_view, 3> kSuffixes = {"L", "U", "UL"};
    return fmt::format("{}{}", value, Chance(5) ? Pick(kSuffixes) : "");
  }

  // Few digits: no decimal of this form is so close to the middle between two fixed-point numbers
  // that conversion through a binary double would round to the other one.
  std::string DoubleLiteral() {
    const std::string sign = Chance(30) ? "-" : "";
    switch (Between(0, 6)) {
      case 0:
        return fmt::format("{}{}", sign, Between(0, 300));  // an int literal beside a double
      case 1:
        return fmt::format("{}{}.{:02}", sign, Between(0, 32000), Between(0, 99));
      case 2:
        return fmt::format("{}.{:06}", sign, Between(0, 999999));
      case 3:
        return fmt::format("{}{}.", sign, Between(0, 1000));
      case 4:
        return fmt::format("{}{}.{}e{}", sign, Between(0, 9), Between(0, 9), Between(-3, 3));
      case 5:
        return program_.format == vm::DoubleFormat::k32_16
                   ? fmt::format("{}{}.{}", sign, Between(0, INT32_MAX - 1), Between(0, 9))
                   : fmt::format("{}{}.{}", sign, Between(0, 32766), Between(0, 9));
      default:
        return fmt::format("{}{}.{:03}", sign, Between(0, 9), Between(0, 999));
    }
  }

  // Means the same in C arithmetic: no operator overflows for two of them.
  std::string SmallLiteral() { return std::to_string(Between(1, 15)); }

  void MakeMacros() {
    const auto add = [this](std::string prefix, std::string body, std::vector<std::string>* list) {
      std::string name = fmt::format("{}{}", prefix, list->size());
      if (Chance(30)) body = '(' + body + ')';
      if (!list->empty() && Chance(15)) body = Pick(*list);
      program_.macros.emplace_back(name, body);
      list->push_back(std::move(name));
    };
    for (int i = Between(0, 3); i > 0; --i) add("KI", IntLiteral(), &int_macros_);
    for (int i = Between(0, 2); i > 0; --i) {
      add("KD", fmt::format("{}{}.{}", Chance(30) ? "-" : "", Between(0, 99), Between(0, 99)),
          &double_macros_);
    }
    for (int i = Between(0, 2); i > 0; --i) {
      add("INDEX_", std::to_string(Between(0, kIndexMask)), &index_macros_);
    }
  }

  // --- Declarations ------------------------------------------------------------------------------

  static std::string Spelling(DataType type) { return type == DataType::kInt ? "int" : "double"; }
  int64_t Initial(DataType type) { return type == DataType::kInt ? AnyInt() : AnyRaw(); }

  void AddScalar(const std::string& spelling, const std::string& name, DataType type,
                 int64_t initial, std::vector<Declaration>* out) {
    out->push_back({spelling + ' ' + name, {{name, name, 0, type, initial}}});
  }

  void AddScalars(const std::string& prefix, DataType type, int count,
                  std::vector<Declaration>* out, Scope* scope) {
    static constexpr std::array<std::string_view, 4> kIntSpellings = {"int", "int", "long",
                                                                      "short"};
    const bool is_int = type == DataType::kInt;
    for (int i = 0; i < count; ++i) {
      const std::string name = fmt::format("{}{}{}", prefix, is_int ? 'i' : 'd', i);
      AddScalar(is_int ? std::string(Pick(kIntSpellings)) : "double", name, type, Initial(type),
                out);
      (is_int ? scope->ints : scope->doubles).push_back(name);
      (is_int ? scope->int_targets : scope->double_targets).push_back(name);
    }
  }

  void AddArray(const std::string& name, DataType type, std::vector<Declaration>* out,
                Scope* scope) {
    const int size = Between(kArrayMin, kArrayMin + 4);
    Declaration array{fmt::format("{} {}[{}]", Spelling(type), name, size), {}};
    for (int i = 0; i < size; ++i) {
      array.slots.push_back({fmt::format("{}[{}]", name, i), name, i, type, Initial(type)});
    }
    out->push_back(std::move(array));
    (type == DataType::kInt ? scope->int_arrays : scope->double_arrays).push_back(name);
  }

  void AddStructure(const std::string& name, std::vector<Declaration>* out, Scope* scope) {
    struct Shape {
      std::string_view type;
      std::vector<std::string_view> doubles, ints;
    };
    static const std::array<Shape, 3> kShapes = {
        {{"TTrapPrm", {"acc", "dec", "velStart"}, {"smoothTime"}},
         {"TJogPrm", {"acc", "dec", "smooth"}, {}},
         {"TPid",
          {"kp", "ki", "kd", "kvff", "kaff"},
          {"integralLimit", "derivativeLimit", "limit"}}}};
    const Shape& shape = Pick(kShapes);
    Declaration structure{fmt::format("{} {}", shape.type, name), {}};
    for (const DataType type : {DataType::kDouble, DataType::kInt}) {
      for (const auto member : type == DataType::kInt ? shape.ints : shape.doubles) {
        const std::string full = fmt::format("{}.{}", name, member);
        structure.slots.push_back({full, full, 0, type, Initial(type)});
        const bool is_int = type == DataType::kInt;
        (is_int ? scope->ints : scope->doubles).push_back(full);
        (is_int ? scope->int_targets : scope->double_targets).push_back(full);
      }
    }
    out->push_back(std::move(structure));
  }

  void MakeVariables(const std::string& prefix, int least, std::vector<Declaration>* out,
                     Scope* scope) {
    AddScalars(prefix, DataType::kInt, Between(least, 4), out, scope);
    AddScalars(prefix, DataType::kDouble, Between(1, 3), out, scope);
    if (Chance(50)) AddArray(prefix + "a", DataType::kInt, out, scope);
    if (Chance(40)) AddArray(prefix + "b", DataType::kDouble, out, scope);
    if (Chance(15)) AddStructure(prefix + "s", out, scope);
    const std::string index = prefix + "x";
    AddScalar("int", index, DataType::kInt, Between(0, kIndexMask), out);
    scope->ints.push_back(index);
    scope->indices.push_back(index);
    if (prefix == "g" && interleaved()) return;
    for (int i = 0; i < 3; ++i) {
      const std::string counter = fmt::format("{}n{}", prefix, i);
      AddScalar("int", counter, DataType::kInt, AnyInt(), out);
      scope->ints.push_back(counter);
      scope->counters.push_back(counter);
    }
  }

  // --- Operands ----------------------------------------------------------------------------------

  std::string Index() {
    if (Chance(70)) return Pick(&Scope::indices);
    if (!index_macros_.empty() && Chance(30)) return Pick(index_macros_);
    return std::to_string(Between(0, kIndexMask));
  }
  bool HasArray(std::vector<std::string> Scope::*list) const {
    return !(local_.*list).empty() || !(global_.*list).empty();
  }
  std::string ElementOf(std::vector<std::string> Scope::*list) {
    const std::string array = Pick(list);
    return fmt::format("{}[{}]", array, Index());
  }

  std::string IntPlace() {
    if (Chance(25) && HasArray(&Scope::int_arrays)) return ElementOf(&Scope::int_arrays);
    return Pick(&Scope::ints);
  }
  std::string DoublePlace() {
    if (Chance(25) && HasArray(&Scope::double_arrays)) return ElementOf(&Scope::double_arrays);
    return Pick(&Scope::doubles);
  }
  std::string IntTarget() {
    if (Chance(20) && HasArray(&Scope::int_arrays)) return ElementOf(&Scope::int_arrays);
    return Pick(&Scope::int_targets);
  }
  std::string DoubleTarget() {
    if (Chance(20) && HasArray(&Scope::double_arrays)) return ElementOf(&Scope::double_arrays);
    return Pick(&Scope::double_targets);
  }
  std::string IntConstant() {
    return !int_macros_.empty() && Chance(25) ? Pick(int_macros_) : IntLiteral();
  }
  std::string DoubleConstant() {
    return !double_macros_.empty() && Chance(25) ? Pick(double_macros_) : DoubleLiteral();
  }
  std::string IntOperand() { return Chance(25) ? IntConstant() : IntPlace(); }
  std::string DoubleOperand() { return Chance(25) ? DoubleConstant() : DoublePlace(); }

  // Two operands: at most one of them is an arbitrary literal, or both are small ones.
  std::pair<std::string, std::string> IntPair() {
    if (Chance(3)) return {SmallLiteral(), SmallLiteral()};
    return Chance(50) ? std::pair{IntPlace(), IntOperand()} : std::pair{IntOperand(), IntPlace()};
  }
  std::pair<std::string, std::string> DoublePair() {
    return Chance(50) ? std::pair{DoublePlace(), DoubleOperand()}
                      : std::pair{DoubleOperand(), DoublePlace()};
  }

  std::string Binary(const std::string& a, std::string_view op, const std::string& b) {
    // `--` is another token, and C would read a hexadecimal E and a sign as one number.
    const bool joins = (op == "-" && b[0] == '-') || a.starts_with("0x");
    return Chance(15) && !joins ? fmt::format("{}{}{}", a, op, b)
                                : fmt::format("{} {} {}", a, op, b);
  }

  // --- Statements --------------------------------------------------------------------------------

  void Emit(Statement statement) {
    if (statement.kind != Statement::Kind::kEmpty) {
      statement.labels = std::exchange(next_labels_, {});
    }
    function_->body.push_back(std::move(statement));
  }
  void Assign(const std::string& target, const std::string& value) {
    Statement statement;
    statement.text = fmt::format("{} = {}", target, value);
    Emit(std::move(statement));
  }
  void Goto(const std::string& label) {
    Statement statement;
    statement.kind = Statement::Kind::kGoto;
    statement.target = label;
    Emit(std::move(statement));
  }
  void IfGoto(const std::string& condition, const std::string& label) {
    Statement statement;
    statement.kind = Statement::Kind::kIfGoto;
    statement.condition = condition;
    statement.target = label;
    Emit(std::move(statement));
  }
  std::string NewLabel() { return fmt::format("label{}", label_count_++); }
  void PutLabel(const std::string& label) { next_labels_.push_back(label); }

  std::string Comparison() {
    static constexpr std::array<std::string_view, 6> kRelations = {"==", "!=", "<",
                                                                   "<=", ">",  ">="};
    const auto [a, b] = Chance(70) ? IntPair() : DoublePair();
    return Binary(a, Pick(kRelations), b);
  }

  std::string IntDivision() {
    static constexpr std::array<std::string_view, 2> kOperators = {"/", "%"};
    const std::string_view op = Pick(kOperators);
    if (Chance(50)) {
      const int32_t divisor = AnyInt();
      return Binary(IntPlace(), op, std::to_string(divisor == 0 ? -1 : divisor));
    }
    if (Chance(15)) return Binary(IntOperand(), op, IntPlace());  // may fault
    const std::string divisor = Pick(&Scope::int_targets);
    Assign(divisor, divisor + " | 1");
    return Binary(IntOperand(), op, divisor);
  }

  void IntStatement() {
    static constexpr std::array<std::string_view, 10> kOperators = {"+", "-",  "*",  "&", "|",
                                                                    "^", "&&", "||", "+", "-"};
    static constexpr std::array<std::string_view, 2> kShifts = {"<<", ">>"};
    static constexpr std::array<std::string_view, 2> kUnary = {"!", "~"};
    switch (Between(0, 9)) {
      case 0:
        return Assign(IntTarget(), IntOperand());
      case 1:
        return Assign(IntTarget(), std::string(Pick(kUnary)) + IntPlace());
      case 2:
        return Assign(IntTarget(), fmt::format("abs({})", IntPlace()));
      case 3:
        return Assign(IntTarget(), fmt::format("(int){}", DoubleOperand()));
      case 4:
        return Assign(IntTarget(), Comparison());
      case 5: {
        const std::string count = Chance(70) ? std::to_string(Between(-2, 40)) : IntPlace();
        return Assign(IntTarget(), Binary(IntPlace(), Pick(kShifts), count));
      }
      case 6: {
        const std::string division = IntDivision();
        return Assign(IntTarget(), division);
      }
      default: {
        const auto [a, b] = IntPair();
        return Assign(IntTarget(), Binary(a, Pick(kOperators), b));
      }
    }
  }

  void DoubleStatement() {
    static constexpr std::array<std::string_view, 3> kOperators = {"+", "-", "*"};
    switch (Between(0, 6)) {
      case 0:
        return Assign(DoubleTarget(), DoubleOperand());
      case 1:
        return Assign(DoubleTarget(), fmt::format("fabs({})", DoublePlace()));
      case 2:
        return Assign(DoubleTarget(), fmt::format("(double){}", IntPlace()));
      case 3:
        return DoubleDivision();
      default: {
        const auto [a, b] = DoublePair();
        return Assign(DoubleTarget(), Binary(a, Pick(kOperators), b));
      }
    }
  }

  // Divides by a literal, by a variable that was made positive or, sometimes, by anything.
  void DoubleDivision() {
    if (Chance(40)) {
      return Assign(DoubleTarget(), Binary(DoublePlace(), "/",
                                           fmt::format("{}{}.{}", Chance(40) ? "-" : "",
                                                       Between(0, 300), Between(1, 9))));
    }
    if (Chance(15)) return Assign(DoubleTarget(), Binary(DoubleOperand(), "/", DoublePlace()));
    const std::string divisor = Pick(&Scope::double_targets);
    Assign(divisor, fmt::format("(double){}", Pick(&Scope::ints)));
    Assign(divisor, fmt::format("{} + .{}", divisor, Between(1, 9)));
    Assign(DoubleTarget(), Binary(DoubleOperand(), "/", divisor));
  }

  void IndexStatement() {
    const bool local = Chance(60);
    const std::string index = local ? local_.indices[0] : global_.indices[0];
    if (local && Chance(50)) {
      Assign(index, fmt::format("{} % {}", IntPlace(), kIndexMask + 1));
      Assign(index, fmt::format("abs({})", index));
    } else {
      Assign(index, fmt::format("{} & {}", IntPlace(), kIndexMask));
    }
  }

  // Two additions that are often the last ones in loops, in the forms that the interpreter fuses.
  void AccumulateStatement() {
    if (Chance(65)) {
      const std::string target = Pick(&Scope::int_targets);
      Assign(target, fmt::format("{} + {}", target, IntPlace()));
    } else if (Chance(50) && HasArray(&Scope::int_arrays)) {
      Assign(ElementOf(&Scope::int_arrays), Pick(&Scope::ints));
    } else {
      const std::string target = Pick(&Scope::double_targets);
      Assign(target, fmt::format("{} + {}", target, DoublePlace()));
    }
  }

  void ForwardJump() {
    // Jumps to the end of this block or of an enclosing one; labels are also placed in between.
    auto& level =
        open_labels_[static_cast<size_t>(Between(0, static_cast<int>(open_labels_.size()) - 1))];
    const std::string label = NewLabel();
    level.push_back(label);
    if (Chance(10)) return Goto(label);
    if (Chance(30)) return IfGoto(Pick(&Scope::ints), label);
    const std::string condition = Pick(&Scope::int_targets);
    Assign(condition, Comparison());
    IfGoto(condition, label);
  }

  std::string ReturnValue() {
    if (function_->result == "void") return "";
    return function_->result == "double" ? DoubleOperand() : IntOperand();
  }

  void Return(bool conditional) {
    Statement statement;
    statement.kind = conditional ? Statement::Kind::kIfReturn : Statement::Kind::kReturn;
    if (conditional) statement.condition = Pick(&Scope::ints);
    statement.value = ReturnValue();
    Emit(std::move(statement));
  }

  // A loop with its own counter. Most have the form in the manual's table, with all comparison
  // operators; some are entered in the middle.
  void Loop() {
    Scope& owner = !global_.counters.empty() && Chance(20) ? global_ : local_;
    if (owner.counters.size() < 2) return IntStatement();
    const std::string counter = owner.counters.back();
    owner.counters.pop_back();
    if (Chance(25)) {
      CountDown(counter);
    } else {
      CountUp(&owner, counter);
    }
    owner.counters.push_back(counter);
  }

  void CountDown(const std::string& counter) {
    const std::string begin = NewLabel();
    Assign(counter, std::to_string(Between(1, kLoopMax)));
    PutLabel(begin);
    Body(counter);
    Assign(counter, counter + " - 1");
    IfGoto(counter, begin);
  }

  void CountUp(Scope* owner, const std::string& counter) {
    const std::string begin = NewLabel(), end = NewLabel(), entry = NewLabel();
    const int count = Between(1, kLoopMax);
    std::string limit = std::to_string(count);
    Assign(counter, "0");
    bool limit_variable = Chance(40) && owner->counters.size() > 1;
    if (limit_variable) {
      Assign(owner->counters.back(), limit);
      limit = owner->counters.back();
      owner->counters.pop_back();
    }
    const int entry_place = Chance(25) ? Between(1, 3) : 0;
    if (entry_place != 0) Goto(entry);
    // Not a shared variable: another thread would change the number of iterations, perhaps without
    // end.
    const std::string condition = Pick(local_.int_targets);
    const int form = Between(0, 3);
    PutLabel(begin);
    if (form == 0) {  // the condition to stay
      static constexpr std::array<std::string_view, 2> kStay = {"<", "!="};
      const std::string body = NewLabel();
      Assign(condition, fmt::format("{} {} {}", counter, Pick(kStay), limit));
      if (entry_place == 1) PutLabel(entry);
      IfGoto(condition, body);
      Goto(end);
      PutLabel(body);
    } else {  // the condition to leave
      static constexpr std::array<std::string_view, 2> kLeave = {">=", "=="};
      Assign(condition, form == 1 ? fmt::format("{} <= {}", limit, counter)
                                  : fmt::format("{} {} {}", counter, Pick(kLeave), limit));
      if (entry_place == 1) PutLabel(entry);
      IfGoto(condition, end);
    }
    Body(counter);
    if (entry_place == 2) PutLabel(entry);
    if (Chance(60)) AccumulateStatement();
    if (entry_place == 3) PutLabel(entry);
    Assign(counter, counter + " + 1");
    Goto(begin);
    PutLabel(end);
    if (limit_variable) owner->counters.push_back(limit);
  }

  void Body(const std::string& counter) {
    local_.indices.push_back(counter);
    Block(Between(0, 4));
    local_.indices.pop_back();
  }

  void Block(int statements) {
    open_labels_.emplace_back();
    for (int i = 0; i < statements; ++i) {
      while (!open_labels_.back().empty() && Chance(30)) {
        PutLabel(open_labels_.back().back());
        open_labels_.back().pop_back();
      }
      OneStatement();
    }
    for (const std::string& label : open_labels_.back()) PutLabel(label);
    open_labels_.pop_back();
  }

  void OneStatement() {
    const int kind = Between(1, 100);
    if (kind <= 38) return IntStatement();
    if (kind <= 58) return DoubleStatement();
    if (kind <= 65) return IndexStatement();
    if (kind <= 72) return AccumulateStatement();
    if (kind <= 84) return ForwardJump();
    if (kind <= 94 && open_labels_.size() <= kNestingMax) return Loop();
    if (kind == 95) return Return(/*conditional=*/true);
    if (kind == 96) {
      Statement empty;
      empty.kind = Statement::Kind::kEmpty;
      return Emit(std::move(empty));
    }
    IntStatement();
  }

  void MakeFunction(int number) {
    static constexpr std::array<std::string_view, 6> kResults = {"int",    "int",  "long",
                                                                 "double", "void", "short"};
    program_.functions.emplace_back();
    function_ = &program_.functions.back();
    function_->name = fmt::format("f{}", number);
    function_->result = Pick(kResults);
    local_ = Scope{};
    label_count_ = 0;
    AddScalars("p", DataType::kInt, Between(0, 2), &function_->parameters, &local_);
    AddScalars("p", DataType::kDouble, Between(0, 1), &function_->parameters, &local_);
    MakeVariables("l", 1, &function_->locals, &local_);
    Block(interleaved() ? Between(4, 10) : Between(5, 18));
    if (!next_labels_.empty() || Chance(60)) Return(/*conditional=*/false);
  }

  Sharing sharing_;
  RandomProgram program_;
  Scope global_;
  Scope local_;
  RandomFunction* function_ = nullptr;
  std::vector<std::string> int_macros_, double_macros_, index_macros_;
  std::vector<std::string> next_labels_;  // labels of the next statement
  std::vector<std::vector<std::string>>
      open_labels_;  // targets of jumps that are not placed yet, by block
  int label_count_ = 0;
};

}  // namespace

RandomProgram MakeProgram(uint64_t seed, Sharing sharing) {
  return Generator(seed, sharing).Make();
}

std::string StatementText(const Statement& statement) {
  const std::string value = statement.value.empty() ? "" : ' ' + statement.value;
  switch (statement.kind) {
    case Statement::Kind::kAssign:
      return statement.text + ";";
    case Statement::Kind::kGoto:
      return fmt::format("goto {};", statement.target);
    case Statement::Kind::kIfGoto:
      return fmt::format("if ({}) goto {};", statement.condition, statement.target);
    case Statement::Kind::kReturn:
      return fmt::format("return{};", value);
    case Statement::Kind::kIfReturn:
      return fmt::format("if ({}) return{};", statement.condition, value);
    case Statement::Kind::kEmpty:
      break;
  }
  return ";";
}

std::string SourceText(const RandomProgram& program) {
  std::string text;
  for (const auto& [name, body] : program.macros) {
    text += fmt::format("#define {} {}\n", name, body);
  }
  for (const Declaration& global : program.globals) text += global.text + ";\n";
  for (const RandomFunction& function : program.functions) {
    text += fmt::format("{} {}(", function.result, function.name);
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      text += (i == 0 ? "" : ", ") + function.parameters[i].text;
    }
    text += ") {\n";
    for (const Declaration& local : function.locals) text += "  " + local.text + ";\n";
    text += fmt::format("  {}\n", kAfterLocals);
    for (const Statement& statement : function.body) {
      for (const std::string& label : statement.labels) text += label + ":\n";
      text += "  " + StatementText(statement) + '\n';
    }
    text += fmt::format("  {}\n}}\n", kBeforeEnd);
  }
  return text;
}

}  // namespace oncard::differential
