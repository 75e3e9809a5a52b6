#include "compiler/lowering/printer.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "compiler/dialect.h"
#include "compiler/lowering/kept_comments.h"
#include "compiler/lowering/speller.h"
#include "compiler/lowering/written_names.h"

namespace oncard::compiler::lowering {
namespace {

constexpr size_t kDeclarationWidth = 80;

class Printer {
 public:
  Printer(const Program& program, const StructuredSource& source, const LoweringOptions& options)
      : program_(program),
        files_(source.files()),
        options_(options),
        speller_(program),
        kept_(program, source.tree(), source.files(),
              options.comments ? std::span<const SourceComment>(source.comments())
                               : std::span<const SourceComment>()) {}

  PrintedProgram Run() {
    PrintLines(kept_.title());
    EmptyLine();
    PrintToolComments();
    PrintConstants();
    for (const int global : program_.globals) PrintGlobal(VariableAt(global));
    for (const LoweredFunction& function : program_.functions) PrintFunction(function);
    if (!kept_.rest().empty()) EmptyLine();
    PrintLines(kept_.rest());
    return std::move(out_);
  }

 private:
  static constexpr SourceRange Nowhere() {
    SourceRange range;
    range.file = -1;
    return range;
  }

  void Line(const std::string& text, SourceRange origin) { Line(text, origin, {origin}); }

  void Line(const std::string& text, SourceRange origin, const StatementOfC& statement) {
    out_.text += text + '\n';
    out_.origins.push_back(origin);
    out_.statements.push_back(statement);
  }

  // Separates what follows from what stands there.
  void EmptyLine() {
    if (!out_.text.empty() && !out_.text.ends_with("\n\n")) Line("", Nowhere());
  }

  int LineAt(int file, uint32_t offset) const {
    return files_[static_cast<size_t>(file)].LineOf(offset);
  }
  int LineOf(const SourceRange& place) const { return LineAt(place.file, place.begin); }

  bool IsBehindEmptyLine(const SourceRange& place) const {
    const int line = LineOf(place);
    return line > 1 && Trim(files_[static_cast<size_t>(place.file)].Line(line - 1)).empty();
  }

  void PrintLines(const SourceComment& comment, std::string_view indent) {
    for (const std::string& line : kept_.LinesOf(comment)) {
      Line(line.empty() ? line : fmt::format("{}{}", indent, line), comment.range);
    }
  }

  // Comments outside of functions.
  void PrintLines(const Comments& comments) {
    for (const SourceComment* comment : comments) {
      if (IsBehindEmptyLine(comment->range)) EmptyLine();
      PrintLines(*comment, "");
    }
  }

  // What stands in C above a declaration outside of functions: comments, and an empty line.
  void PrintAbove(const SourceRange& place) {
    const Comments comments = kept_.TakeAbove(place);
    PrintLines(comments);
    const SourceRange declaration = kept_.DeclarationAt(place);
    // It may stand farther below.
    const bool apart = !comments.empty() &&
                       LineAt(place.file, comments.back()->range.end) + 1 < LineOf(declaration);
    if (apart || IsBehindEmptyLine(declaration)) EmptyLine();
  }

  void PrintGlobal(const Variable& variable) {
    std::string line = fmt::format("{} {};", SpellType(variable), Declare(variable));
    StatementOfC statement = {variable.range.end > 0 ? variable.range : Nowhere(), true};
    if (variable.range.end > 0 && kept_.FunctionAt(variable.range) < 0) {
      const SourceRange declaration = kept_.DeclarationAt(variable.range);
      if (declarations_.emplace(declaration.file, declaration.begin).second) {
        PrintAbove(variable.range);
      }
      statement = {declaration};
      line += kept_.TakeBeside(variable.range);
    }
    Line(line, variable.range, statement);
  }

  const Variable& VariableAt(int number) const {
    return program_.variables[static_cast<size_t>(number)];
  }

  static std::string Declare(const Variable& variable) {
    if (variable.size == 0) return variable.name;
    return fmt::format("{}[{}]", variable.name, variable.size);
  }

  // The locals that the function uses: variables in the order of their declarations, temporaries
  // after them.
  void PrintLocals(const LoweredFunction& function) {
    std::set<std::tuple<bool, vm::DataType, int>> used;
    for (const Instruction& instruction : function.code) {
      ForEachOperand(instruction, [this, &used](const Operand& operand, bool /*written*/) {
        for (const int number : {operand.variable, operand.index}) {
          if (number < 0) continue;
          const Variable::Role role = VariableAt(number).role;
          const bool temporary = role == Variable::Role::kTemporary;
          // Temporaries of one type stand together; variables keep their order.
          const vm::DataType group = temporary ? VariableAt(number).type : vm::DataType::kVoid;
          if (temporary || role == Variable::Role::kLocal) used.emplace(temporary, group, number);
        }
      });
    }
    std::string line;
    std::string_view type;
    const auto flush = [this, &line, &function] {
      if (!line.empty()) Line(line + ";", function.header);
      line.clear();
    };
    for (const auto& [temporary, group, number] : used) {
      const Variable& variable = VariableAt(number);
      const std::string declared = Declare(variable);
      const bool fits = line.size() + declared.size() + 3 <= kDeclarationWidth;
      if (line.empty() || SpellType(variable) != type || !fits) {
        flush();
        type = SpellType(variable);
        line = fmt::format("  {} {}", type, declared);
      } else {
        line += ", " + declared;
      }
    }
    flush();
    PrintSharedSlots(function);
    if (!used.empty()) Line("", Nowhere());
  }

  void PrintSharedSlots(const LoweredFunction& function) {
    for (const SharedSlots& shared : function.shared_slots) {
      std::vector<std::string_view> others;
      for (const int other : shared.others) others.push_back(VariableAt(other).name);
      Line(fmt::format("  // {} is {}, too: their lives do not overlap",
                       VariableAt(shared.owner).name, fmt::join(others, ", ")),
           function.header);
    }
  }

  // The text of C in one line, so that it can be a comment.
  static std::string OneLine(std::string_view text) {
    const std::string line = CommentLine(text);
    const size_t end = text.find_first_of("\r\n");
    return end != std::string_view::npos && end > 0 &&
                   text.find_first_not_of(" \t\r\n", end) != std::string_view::npos
               ? line + " ..."
               : line;
  }

  // An empty line that C has above a line of a function, unless the function begins there.
  void PrintEmptyLineAbove(const SourceRange& place) {
    if (!spaced_.emplace(place.file, LineOf(place)).second || out_.text.size() == body_) return;
    const int function = kept_.FunctionAt(place);
    if (function < 0) return;
    const bool first =
        LineOf(kept_.functions()[static_cast<size_t>(function)].range) == LineOf(place);
    if (!first && IsBehindEmptyLine(place)) EmptyLine();
  }

  void PrintSource(const SourceRange& place, std::string_view text) {
    const SourceFile& file = files_[static_cast<size_t>(place.file)];
    const int line = LineOf(place);
    const std::string where =
        place.file == 0 ? std::to_string(line) : fmt::format("{}:{}", file.path(), line);
    Line(fmt::format("  // {}: {}", where, OneLine(text)), place);
  }

  // A comment in a function: as it is, or with the line of C beside which it stands.
  void PrintKept(const SourceComment& comment) {
    const SourceRange& range = comment.range;
    if (comment.alone) {
      PrintEmptyLineAbove(range);
      PrintLines(comment, "  ");
      return;
    }
    if (printed_.emplace(range.file, LineOf(range)).second) {
      PrintEmptyLineAbove(range);
      PrintSource(range, kept_.LineWithoutTaken(range));
    }
    const std::vector<std::string> lines = kept_.LinesOf(comment);
    for (size_t i = 1; i < lines.size(); ++i) {
      Line(fmt::format("  // {}", WithoutMark(lines[i])), range);
    }
  }

  // A part of a function of C.
  std::string WithoutComments(int function, const SourceRange& range) const {
    const std::string_view source = files_[static_cast<size_t>(range.file)].text();
    std::string text;
    uint32_t begin = range.begin;
    if (function >= 0) {
      const Comments& comments = kept_.functions()[static_cast<size_t>(function)].comments;
      auto comment = std::ranges::lower_bound(
          comments, begin, {}, [](const SourceComment* other) { return other->range.begin; });
      for (; comment != comments.end() && (*comment)->range.begin < range.end; ++comment) {
        text += source.substr(begin, (*comment)->range.begin - begin);
        begin = (*comment)->range.end;
      }
    }
    return text.append(source.substr(begin, range.end - begin));
  }

  // The comments of a function of C up to a place that were not printed yet.
  void PrintKeptBefore(int function, uint32_t place) {
    if (function < 0) return;
    const Comments& comments = kept_.functions()[static_cast<size_t>(function)].comments;
    size_t& next = next_comment_[static_cast<size_t>(function)];
    while (next < comments.size() && comments[next]->range.begin < place) {
      PrintKept(*comments[next++]);
    }
  }

  // The function of C to which a statement belongs. The initial values of static variables stand
  // elsewhere.
  int FunctionOf(int statement) const {
    if (statement < 0 || statement >= program_.start_statements) return -1;
    return kept_.FunctionAt(program_.statements[static_cast<size_t>(statement)]);
  }

  StatementOfC StatementOf(const Instruction& instruction) const {
    if (instruction.kind == Instruction::Kind::kLabel) return {instruction.range};
    return {program_.statements[static_cast<size_t>(instruction.statement)],
            instruction.statement >= program_.start_statements};
  }

  void PrintComment(int statement) {
    if (!options_.comments) return;
    const SourceRange& range = program_.statements[static_cast<size_t>(statement)];
    const std::pair<int, int> place(range.file, LineOf(range));
    if (place == last_place_) return;
    const int function = FunctionOf(statement);
    const SourceFile& file = files_[static_cast<size_t>(range.file)];
    const std::string_view line = file.Line(place.second);
    PrintKeptBefore(function, RangeOf(0, file.text(), line).begin);
    last_place_ = place;
    if (!printed_.insert(place).second) {
      PrintSource(range, WithoutComments(function, range));
      return;
    }
    if (function >= 0) PrintEmptyLineAbove(range);
    PrintSource(range, kept_.LineWithoutTaken(range));
    if (function < 0) return;
    // Those in it and beside it.
    const Comments& comments = kept_.functions()[static_cast<size_t>(function)].comments;
    const int last = file.LineOf(range.end);
    size_t& next = next_comment_[static_cast<size_t>(function)];
    while (next < comments.size() && LineOf(comments[next]->range) <= last) {
      PrintKept(*comments[next++]);
    }
  }

  // Comments between a statement, which is printed, and the brace that closes its block, or its
  // function if that is one that is left.
  void PrintKeptBehind(int statement, int following, int own) {
    const int function = FunctionOf(statement);
    if (function < 0) return;
    const SourceRange& range = program_.statements[static_cast<size_t>(statement)];
    const CommentedFunction& around = kept_.functions()[static_cast<size_t>(function)];
    if (function != following) {
      const bool last = range.begin >= around.last && function != own;
      if (last) PrintKeptBefore(function, around.range.end);
      return;
    }
    const std::string_view text = files_[static_cast<size_t>(range.file)].text();
    size_t& next = next_comment_[static_cast<size_t>(function)];
    for (; next < around.comments.size(); ++next) {
      const SourceComment& comment = *around.comments[next];
      const bool closes = comment.alone && text.substr(comment.behind).starts_with('}');
      const bool follows = comment.before >= range.begin &&
                           (comment.before < range.end ||
                            Trim(text.substr(range.end, comment.before + 1 - range.end)) == ";");
      if (!closes || !follows) return;
      PrintKept(comment);
    }
  }

  // What is worth knowing about a full expression: which of its calls are jumps, and globals that
  // it reads in one statement and writes in a later one.
  void PrintAnnotations(const LoweredFunction& function, size_t begin) {
    const int statement = function.code[begin].statement;
    if (!annotated_.insert(statement).second) return;
    for (const SharedCalls& shared : function.calls) {
      const bool calls = std::any_of(function.code.begin(), function.code.end(),
                                     [&](const Instruction& instruction) {
                                       return instruction.statement == statement &&
                                              instruction.target.variable == shared.number;
                                     });
      if (!calls) continue;
      Line(fmt::format("  // called by a jump: '{}'", shared.name), function.code[begin].range);
    }
    std::map<int, size_t> first_read;
    std::set<int> reported;
    for (size_t i = begin; i < function.code.size(); ++i) {
      const Instruction& instruction = function.code[i];
      if (instruction.statement != statement) continue;
      ForEachOperand(instruction, [&](const Operand& operand, bool written) {
        for (const int number : {operand.variable, operand.index}) {
          if (number < 0 || VariableAt(number).role != Variable::Role::kGlobal) continue;
          const bool writes = written && number == operand.variable;
          if (!writes) {
            first_read.try_emplace(number, i);
            continue;
          }
          const auto read = first_read.find(number);
          if (read == first_read.end() || read->second == i || !reported.insert(number).second) {
            continue;
          }
          Line(fmt::format(
                   "  // not atomic: '{}' is read in one statement and written in a later one",
                   VariableAt(number).name),
               instruction.range);
        }
      });
    }
  }

  // Comments above a function of the card, which is a function of C.
  void PrintAboveFunction(const SourceRange& header, int own) {
    PrintAbove(header);
    if (own < 0) return;
    const CommentedFunction& commented = kept_.functions()[static_cast<size_t>(own)];
    size_t& next = next_comment_[static_cast<size_t>(own)];
    for (; next < commented.comments.size(); ++next) {
      const SourceComment& comment = *commented.comments[next];
      if (comment.range.begin >= commented.range.begin) break;
      if (IsBehindEmptyLine(comment.range)) EmptyLine();
      PrintLines(comment, "");
    }
    if (IsBehindEmptyLine(commented.range)) EmptyLine();
  }

  // Those beside its header, unless a statement stands there too.
  std::string TakeBesideHeader(int own) {
    std::string text;
    if (own < 0) return text;
    const CommentedFunction& commented = kept_.functions()[static_cast<size_t>(own)];
    const SourceFile& file = files_[static_cast<size_t>(commented.range.file)];
    size_t& next = next_comment_[static_cast<size_t>(own)];
    for (; next < commented.comments.size(); ++next) {
      const SourceComment& comment = *commented.comments[next];
      const bool beside = !comment.alone && comment.range.begin < commented.body &&
                          LineOf(comment.range) < file.LineOf(commented.body);
      if (!beside) break;
      text += "  " + kept_.Take(comment);
    }
    return text;
  }

  void PrintAboveAssert(const Instruction& assert) {
    const SourceRange& comment = program_.assertions[static_cast<size_t>(assert.assertion)].comment;
    const int function = kept_.FunctionAt(comment);
    if (function < 0) return;
    PrintKeptBefore(function, comment.begin);
    PrintEmptyLineAbove(comment);
  }

  // Whether an instruction is the end of a block, whose last statement it belongs to.
  bool LeavesBlock(const Instruction& instruction) const {
    const SourceRange& range = program_.statements[static_cast<size_t>(instruction.statement)];
    return (instruction.kind == Instruction::Kind::kLabel ||
            instruction.kind == Instruction::Kind::kGoto) &&
           instruction.range.begin < range.begin;
  }

  // A label stands in C where its statement begins, such as a case, or where a function does.
  void PrintAboveLabel(const LoweredFunction& function, size_t number) {
    const Instruction& label = function.code[number];
    if (label.statement < 0) return;
    const int around = FunctionOf(label.statement);
    const auto next = std::find_if(
        function.code.begin() + static_cast<std::ptrdiff_t>(number), function.code.end(),
        [](const Instruction& instruction) { return instruction.IsStatement(); });
    const int entered = next == function.code.end() ? -1 : FunctionOf(next->statement);
    if (entered >= 0 && entered != around) {
      PrintKeptBefore(entered, kept_.functions()[static_cast<size_t>(entered)].range.begin);
    }
    if (around < 0 || printed_.contains({label.range.file, LineOf(label.range)}) ||
        kept_.FunctionAt(label.range) != around) {
      return;
    }
    PrintKeptBefore(around, label.range.begin);
    PrintEmptyLineAbove(label.range);
  }

  void PrintFunction(const LoweredFunction& function) {
    EmptyLine();
    next_comment_.assign(kept_.functions().size(), 0);
    const int own = kept_.FunctionAt(function.header);
    PrintAboveFunction(function.header, own);
    std::string parameters;
    for (const int parameter : function.parameters) {
      if (!parameters.empty()) parameters += ", ";
      parameters +=
          fmt::format("{} {}", SpellType(VariableAt(parameter)), VariableAt(parameter).name);
    }
    Line(fmt::format("{} {}({}) {{{}", vm::TypeName(function.type), function.name, parameters,
                     TakeBesideHeader(own)),
         function.header);
    body_ = out_.text.size();
    PrintLocals(function);
    printed_.clear();
    spaced_.clear();
    annotated_.clear();
    last_place_ = {-1, -1};
    int newest = -1;
    int previous = -1;
    for (size_t i = 0; i < function.code.size(); ++i) {
      const Instruction& instruction = function.code[i];
      if (instruction.statement >= 0) {
        if (instruction.statement != previous || LeavesBlock(instruction)) {
          PrintKeptBehind(previous, FunctionOf(instruction.statement), own);
        }
        previous = instruction.statement;
      }
      if (instruction.kind == Instruction::Kind::kAssert) {
        PrintAboveAssert(instruction);
        const std::string text = speller_.Spell(instruction, function);
        const SourceRange& comment =
            program_.assertions[static_cast<size_t>(instruction.assertion)].comment;
        Line("  " + text, instruction.range, {comment});
        // A backslash at its end continues the comment with an empty line.
        if (text.ends_with('\\')) Line("", Nowhere());
        continue;
      }
      const bool label = instruction.kind == Instruction::Kind::kLabel;
      if (label) PrintAboveLabel(function, i);
      if (!label || instruction.statement > newest) {
        PrintComment(instruction.statement);
        if (options_.annotate) PrintAnnotations(function, i);
      }
      newest = std::max(newest, instruction.statement);
      Line((label ? "" : "  ") + speller_.Spell(instruction, function), instruction.range,
           StatementOf(instruction));
    }
    PrintKeptBehind(previous, own, own);
    PrintKeptBefore(own, function.end.begin);
    if (!function.code.empty() && !function.code.back().IsStatement()) {
      Line(function.type == vm::DataType::kVoid ? "  return;" : "  return 0;", function.end);
    }
    const bool beside = !printed_.contains({function.end.file, LineOf(function.end)});
    Line(beside ? "}" + kept_.TakeBeside(function.end) : "}", function.end);
  }

  // The explorer finds the program's requirements in these lines. All names in them are those of
  // the lowered program, in structured C too.
  void PrintToolComments() {
    const std::string_view source = files_[0].text();
    ForEachToolComment(source, [this, source](int /*number*/, std::string_view line) {
      SourceRange range;
      range.begin = static_cast<uint32_t>(line.data() - source.data());
      range.end = range.begin + static_cast<uint32_t>(line.size());
      Line(NameAsLowered(program_, Trim(line)), range, {range, true});
    });
    // A backslash at the end of the last one continues the comment with an empty line.
    EmptyLine();
  }

  // Where the first global or function of the program stands.
  uint32_t BeginOfDeclarations() const {
    uint32_t begin = UINT32_MAX;
    const auto include = [&begin](const SourceRange& range) {
      if (range.file == 0) begin = std::min(begin, range.begin);
    };
    for (const int global : program_.globals) {
      include(program_.variables[static_cast<size_t>(global)].range);
    }
    for (const LoweredFunction& function : program_.functions) include(function.header);
    return begin;
  }

  // The constants that are used by their names, which nothing else in the program must have.
  void PrintConstants() {
    std::set<std::string_view> taken;
    std::set<std::pair<std::pair<int, uint32_t>, int>> used;  // in the order of C
    for (const Variable& variable : program_.variables) taken.insert(variable.name);
    for (const LoweredFunction& function : program_.functions) {
      taken.insert(function.name);
      taken.insert(function.labels.begin(), function.labels.end());
      for (const Instruction& instruction : function.code) {
        for (const Operand& argument : instruction.arguments) {
          if (argument.name < 0) continue;
          const SourceRange& range = program_.constants[static_cast<size_t>(argument.name)].range;
          used.insert({{range.file, range.begin}, argument.name});
        }
      }
    }
    const uint32_t others = BeginOfDeclarations();
    for (const auto& [place, number] : used) {
      const NamedConstant& constant = program_.constants[static_cast<size_t>(number)];
      if (constant.ambiguous || taken.contains(constant.name)) continue;
      PrintAbove(constant.range);
      const bool moved = constant.range.file != 0 || constant.range.begin > others;
      Line(fmt::format("#define {} {}{}", constant.name, speller_.Spell(constant.value),
                       kept_.TakeBeside(constant.range)),
           constant.range, {constant.range, moved});
      speller_.UseName(number);
    }
    EmptyLine();
  }

  const Program& program_;
  const std::deque<SourceFile>& files_;
  const LoweringOptions& options_;
  Speller speller_;
  KeptComments kept_;
  PrintedProgram out_;
  std::set<std::pair<int, uint32_t>> declarations_;  // those of the globals
  size_t body_ = 0;                                  // where the body of the function begins
  std::set<std::pair<int, int>> printed_;            // lines of C that are in the function already
  std::set<std::pair<int, int>> spaced_;             // those whose empty lines are
  std::vector<size_t> next_comment_;                 // of each function of C
  std::set<int> annotated_;
  std::pair<int, int> last_place_;
};

}  // namespace

PrintedProgram Print(const Program& program, const StructuredSource& source,
                     const LoweringOptions& options) {
  return Printer(program, source, options).Run();
}

}  // namespace oncard::compiler::lowering
