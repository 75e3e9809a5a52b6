#include "compiler/lowering/printer.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
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
  Printer(const Program& program, const StructuredSource& source, bool annotate)
      : program_(program),
        files_(source.files()),
        annotate_(annotate),
        speller_(program),
        kept_(program, source.tree(), source.files(), source.comments()) {}

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

  void Line(const std::string& text, SourceRange origin) {
    out_.text += text + '\n';
    out_.origins.push_back(origin);
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

  void PrintLines(const SourceComment& comment) {
    for (const std::string& line : kept_.LinesOf(comment)) Line(line, comment.range);
  }

  // Comments outside of functions.
  void PrintLines(const Comments& comments) {
    for (const SourceComment* comment : comments) {
      if (IsBehindEmptyLine(comment->range)) EmptyLine();
      PrintLines(*comment);
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
    if (variable.range.end > 0 && kept_.FunctionAt(variable.range) < 0) {
      const SourceRange declaration = kept_.DeclarationAt(variable.range);
      if (declarations_.emplace(declaration.file, declaration.begin).second) {
        PrintAbove(variable.range);
      }
      line += kept_.TakeBeside(variable.range);
    }
    Line(line, variable.range);
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
      std::string others;
      for (const int other : shared.others) {
        others += (others.empty() ? "" : ", ") + VariableAt(other).name;
      }
      Line(fmt::format("  // {} is {}, too: their lives do not overlap",
                       VariableAt(shared.owner).name, others),
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

  void PrintSource(const SourceRange& place, std::string_view text) {
    const SourceFile& file = files_[static_cast<size_t>(place.file)];
    const int line = LineOf(place);
    const std::string where =
        place.file == 0 ? std::to_string(line) : fmt::format("{}:{}", file.path(), line);
    Line(fmt::format("  // {}: {}", where, OneLine(text)), place);
  }

  void PrintComment(int statement) {
    const SourceRange& range = program_.statements[static_cast<size_t>(statement)];
    const std::pair<int, int> place(range.file, LineOf(range));
    if (place == last_place_) return;
    last_place_ = place;
    if (printed_.insert(place).second) {
      PrintSource(range, kept_.LineWithoutTaken(range));
      return;
    }
    const std::string_view text = files_[static_cast<size_t>(range.file)].text();
    PrintSource(range, text.substr(range.begin, range.end - range.begin));
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
      PrintLines(comment);
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
    PrintLocals(function);
    printed_.clear();
    annotated_.clear();
    last_place_ = {-1, -1};
    int newest = -1;
    for (size_t i = 0; i < function.code.size(); ++i) {
      const Instruction& instruction = function.code[i];
      if (instruction.kind == Instruction::Kind::kAssert) {
        const std::string text = speller_.Spell(instruction, function);
        Line("  " + text, instruction.range);
        // A backslash at its end continues the comment with an empty line.
        if (text.ends_with('\\')) Line("", Nowhere());
        continue;
      }
      const bool label = instruction.kind == Instruction::Kind::kLabel;
      if (!label || instruction.statement > newest) {
        PrintComment(instruction.statement);
        if (annotate_) PrintAnnotations(function, i);
      }
      newest = std::max(newest, instruction.statement);
      Line((label ? "" : "  ") + speller_.Spell(instruction, function), instruction.range);
    }
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
      Line(NameAsLowered(program_, Trim(line)), range);
    });
    // A backslash at the end of the last one continues the comment with an empty line.
    EmptyLine();
  }

  // The constants that are used by their names, which nothing else in the program must have.
  void PrintConstants() {
    std::set<std::string_view> taken;
    std::set<int> used;
    for (const Variable& variable : program_.variables) taken.insert(variable.name);
    for (const LoweredFunction& function : program_.functions) {
      taken.insert(function.name);
      taken.insert(function.labels.begin(), function.labels.end());
      for (const Instruction& instruction : function.code) {
        for (const Operand& argument : instruction.arguments) used.insert(argument.name);
      }
    }
    for (const int number : used) {
      if (number < 0) continue;
      const NamedConstant& constant = program_.constants[static_cast<size_t>(number)];
      if (constant.ambiguous || taken.contains(constant.name)) continue;
      PrintAbove(constant.range);
      Line(fmt::format("#define {} {}{}", constant.name, speller_.Spell(constant.value),
                       kept_.TakeBeside(constant.range)),
           constant.range);
      speller_.UseName(number);
    }
    EmptyLine();
  }

  const Program& program_;
  const std::deque<SourceFile>& files_;
  const bool annotate_;
  Speller speller_;
  KeptComments kept_;
  PrintedProgram out_;
  std::set<std::pair<int, uint32_t>> declarations_;  // those of the globals
  std::set<std::pair<int, int>> printed_;            // lines of C that are in the function already
  std::vector<size_t> next_comment_;                 // of each function of C
  std::set<int> annotated_;
  std::pair<int, int> last_place_;
};

}  // namespace

PrintedProgram Print(const Program& program, const StructuredSource& source, bool annotate) {
  return Printer(program, source, annotate).Run();
}

}  // namespace oncard::compiler::lowering
