#include "session/editor_requests.h"

#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "compiler/diagnostic_printer.h"
#include "compiler/fix_it_applier.h"
#include "compiler/lowering/lowering.h"
#include "compiler/lowering/two_columns.h"
#include "editor/complete.h"
#include "editor/describe.h"
#include "editor/overview.h"
#include "editor/places.h"
#include "session/comment_help.h"
#include "session/project.h"
#include "session/scenario_help.h"

namespace oncard::session {
namespace {

// What a request is about.
struct Subject {
  editor::ProgramFiles program;
  std::unique_ptr<editor::Analysis> analysis;
  int file = 0;  // of the program's files

  compiler::Compilation Compile() const {
    return compiler::CompileText(program.path, program.text, program.options, program.reader);
  }
};

// The arguments of a request about a file.
struct Wish {
  std::string main;
  std::string file;
  std::map<std::string, std::string> files;
  bool structured = false;
};

Wish ReadProgramWish(Arguments& arguments) {
  Wish wish;
  wish.main = arguments.Text("main");
  wish.files = arguments.TextsByName("files");
  wish.structured = arguments.Flag("structured", false);
  return wish;
}

Wish ReadWish(Arguments& arguments) {
  Wish wish = ReadProgramWish(arguments);
  wish.file = arguments.Text("file", {});
  return wish;
}

// The program of a request. Its reader notes in the context which files are missing.
Result<editor::ProgramFiles> ReadProgramFiles(Wish wish, const EditorContext& context) {
  const auto files = std::make_shared<const Files>(std::move(wish.files), context.reader);
  auto source = ReadProgramSource(wish.main, *files, wish.structured);
  *context.missing = files->missing();
  if (!source.ok()) return source.error();
  return editor::ProgramFiles{std::move(source.value().path), std::move(source.value().text),
                              std::move(source.value().options),
                              [files, &context](const std::string& path) {
                                auto text = files->Read(path);
                                *context.missing = files->missing();
                                return text;
                              }};
}

Result<Subject> ReadSubject(Wish wish, const EditorContext& context) {
  const std::string file_name = wish.file;
  auto program = ReadProgramFiles(std::move(wish), context);
  if (!program.ok()) return program.error();
  Subject subject;
  subject.program = std::move(program).value();
  subject.analysis = std::make_unique<editor::Analysis>(
      subject.program.path, subject.program.text, subject.program.options, subject.program.reader);
  if (file_name.empty()) return subject;
  const auto file = subject.analysis->text.Find(file_name);
  if (!file) {
    return MakeError(1, "the program '{0}' does not include '{1}'", "程序“{0}”未包含“{1}”",
                     subject.program.path, file_name);
  }
  subject.file = *file;
  return subject;
}

// A request about a whole file, answered by `answer(subject)`.
template <typename Answer>
Result<Json> AboutFile(Arguments& arguments, const EditorContext& context, const Answer& answer) {
  Wish wish = ReadWish(arguments);
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  const auto subject = ReadSubject(std::move(wish), context);
  if (!subject.ok()) return subject.error();
  return answer(subject.value());
}

editor::Place ReadPlace(Arguments& arguments) {
  constexpr int64_t kMax = std::numeric_limits<int>::max();
  editor::Place place;
  place.line = static_cast<int>(arguments.Whole("line", 1, kMax));
  place.column = static_cast<int>(arguments.Whole("column", 1, kMax));
  return place;
}

editor::Cursor CursorAt(const Subject& subject, editor::Place place) {
  const auto& file = subject.analysis->text.file(subject.file).file;
  return {subject.file, editor::OffsetOf(file, place)};
}

// A request about a place, answered by `answer(subject, cursor)`.
template <typename Answer>
Result<Json> AnswerAt(Wish wish, editor::Place place, const EditorContext& context,
                      const Answer& answer) {
  const auto subject = ReadSubject(std::move(wish), context);
  if (!subject.ok()) return subject.error();
  return answer(subject.value(), CursorAt(subject.value(), place));
}

template <typename Answer>
Result<Json> AtPlace(Arguments& arguments, const EditorContext& context, const Answer& answer) {
  Wish wish = ReadWish(arguments);
  const editor::Place place = ReadPlace(arguments);
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  return AnswerAt(std::move(wish), place, context, answer);
}

// The same for a request that a scenario answers, too.
template <typename ScenarioAnswer, typename Answer>
Result<Json> AtPlaceOfAny(Arguments& arguments, const EditorContext& context,
                          const ScenarioAnswer& scenario_answer, const Answer& answer) {
  Wish wish = ReadWish(arguments);
  const editor::Place place = ReadPlace(arguments);
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  if (!wish.file.ends_with(".toml")) return AnswerAt(std::move(wish), place, context, answer);
  const Files files(std::move(wish.files), context.reader);
  auto text = files.Read(wish.file);
  *context.missing = files.missing();
  if (!text.ok()) return text.error();
  return scenario_answer({std::move(wish.file), std::move(text).value(), place}, context.language);
}

// The file of a cursor, and its place there.
const compiler::SourceFile& FileOf(const Subject& subject, editor::Cursor cursor) {
  return subject.analysis->text.file(cursor.file).file;
}

editor::Place PlaceOf(const Subject& subject, editor::Cursor cursor) {
  const compiler::SourceFile& file = FileOf(subject, cursor);
  return {file.LineOf(cursor.offset), file.ColumnOf(cursor.offset)};
}

const vm::Object* ObjectOf(const compiler::Compilation& compilation) {
  return compilation.ok() ? &*compilation.object : nullptr;
}

Result<Json> Describe(Arguments& arguments, const EditorContext& context) {
  return AtPlaceOfAny(
      arguments, context, DescribeScenario, [&](const Subject& subject, editor::Cursor cursor) {
        if (auto comment = DescribeComment(FileOf(subject, cursor), PlaceOf(subject, cursor),
                                           context.language)) {
          return *std::move(comment);
        }
        const auto compilation = subject.Compile();
        return editor::Describe(*subject.analysis, cursor, ObjectOf(compilation), context.language);
      });
}

Result<Json> Signature(Arguments& arguments, const EditorContext& context) {
  return AtPlace(arguments, context, [&](const Subject& subject, editor::Cursor cursor) {
    return editor::Signature(*subject.analysis, cursor, context.language);
  });
}

Result<Json> Complete(Arguments& arguments, const EditorContext& context) {
  return AtPlaceOfAny(
      arguments, context, CompleteScenario, [&](const Subject& subject, editor::Cursor cursor) {
        auto comment =
            CompleteComment(FileOf(subject, cursor), PlaceOf(subject, cursor), context.language);
        if (comment) return *std::move(comment);
        return editor::Complete(*subject.analysis, cursor, context.language);
      });
}

Result<Json> Definition(Arguments& arguments, const EditorContext& context) {
  return AtPlace(arguments, context, [](const Subject& subject, editor::Cursor cursor) {
    return editor::Definition(*subject.analysis, cursor);
  });
}

Result<Json> References(Arguments& arguments, const EditorContext& context) {
  const bool declarations = arguments.Flag("declaration", true);
  return AtPlace(arguments, context, [&](const Subject& subject, editor::Cursor cursor) {
    return editor::References(*subject.analysis, cursor, declarations);
  });
}

Result<Json> Rename(Arguments& arguments, const EditorContext& context) {
  const std::string name = arguments.Text("name");
  return AtPlace(arguments, context, [&](const Subject& subject, editor::Cursor cursor) {
    return editor::Rename(*subject.analysis, subject.program, cursor, name);
  });
}

Result<Json> Outline(Arguments& arguments, const EditorContext& context) {
  return AboutFile(arguments, context, [](const Subject& subject) {
    return editor::Outline(*subject.analysis, subject.file);
  });
}

Result<Json> Tokens(Arguments& arguments, const EditorContext& context) {
  return AboutFile(arguments, context, [](const Subject& subject) {
    return editor::Tokens(*subject.analysis, subject.file);
  });
}

Result<Json> Folds(Arguments& arguments, const EditorContext& context) {
  return AboutFile(arguments, context, [](const Subject& subject) {
    return editor::Folds(*subject.analysis, subject.file);
  });
}

Result<Json> Hints(Arguments& arguments, const EditorContext& context) {
  return AboutFile(arguments, context, [](const Subject& subject) {
    const auto compilation = subject.Compile();
    return editor::Hints(*subject.analysis, subject.file, ObjectOf(compilation));
  });
}

Json CompiledJson(const compiler::Compilation& compilation, Language language) {
  return {{"compiled", compilation.ok()},
          {"diagnostics", compiler::DiagnosticsJson(compilation, language)}};
}

// The program of a request that is not about one of its files.
Result<editor::ProgramFiles> ReadWholeProgram(Arguments& arguments, const EditorContext& context) {
  Wish wish = ReadProgramWish(arguments);
  if (auto mistakes = arguments.Mistakes()) return *std::move(mistakes);
  return ReadProgramFiles(std::move(wish), context);
}

Result<Json> Fixes(Arguments& arguments, const EditorContext& context) {
  const auto program = ReadWholeProgram(arguments, context);
  if (!program.ok()) return program.error();
  const auto& [path, text, options, reader] = program.value();
  const auto corrected = compiler::ApplyAllFixIts(path, text, options, reader);
  Json answer = CompiledJson(corrected.compilation, context.language);
  answer["count"] = corrected.count;
  answer["files"] = Json::array();
  for (const auto& [name, changed] : corrected.files) {
    answer["files"].push_back({{"path", name}, {"text", changed}});
  }
  return answer;
}

Result<Json> Lower(Arguments& arguments, const EditorContext& context) {
  const auto program = ReadWholeProgram(arguments, context);
  if (!program.ok()) return program.error();
  const auto& [path, text, options, reader] = program.value();
  if (!compiler::IsStructured(options, text)) {
    return MakeError(1, "'{0}' is not structured C: there is nothing to lower",
                     "“{0}”不是结构化 C：无需转换", path);
  }
  compiler::Lowering lowering = compiler::LowerText(path, text, options, {}, reader);
  const compiler::Compilation compilation = compiler::TakeCompilation(lowering);
  Json answer = CompiledJson(compilation, context.language);
  if (!lowering.text) return answer;
  answer["text"] = *lowering.text;
  answer["origins"] = Json::array();
  for (const compiler::SourceRange& origin : lowering.origins) {
    if (origin.file < 0) {
      answer["origins"].push_back(nullptr);
      continue;
    }
    const compiler::SourceFile& file = compilation.files[static_cast<size_t>(origin.file)];
    answer["origins"].push_back({{"file", file.path()}, {"line", file.LineOf(origin.begin)}});
  }
  return answer;
}

Json TwoColumnsRows(const compiler::Lowering& lowering) {
  Json rows = Json::array();
  for (const compiler::TwoColumnsRow& each : compiler::RowsOf(lowering)) {
    Json row = Json::object();
    if (each.file >= 0) {
      const compiler::SourceFile& file = lowering.files[static_cast<size_t>(each.file)];
      row["file"] = file.path();
      row["line"] = each.line;
      row["text"] = file.Line(each.line);
    }
    if (each.again) row["again"] = true;
    if (each.card_line > 0) {
      row["card"] = each.card;
      row["card_line"] = each.card_line;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<Json> TwoColumns(Arguments& arguments, const EditorContext& context) {
  const auto program = ReadWholeProgram(arguments, context);
  if (!program.ok()) return program.error();
  const auto& [path, text, options, reader] = program.value();
  if (!compiler::IsStructured(options, text)) {
    return CompiledJson(compiler::CompileText(path, text, options, reader), context.language);
  }
  compiler::Lowering lowering =
      compiler::LowerText(path, text, options, {.comments = false}, reader);
  Json rows;
  if (lowering.text) rows = TwoColumnsRows(lowering);
  Json answer = CompiledJson(compiler::TakeCompilation(lowering), context.language);
  if (lowering.text) answer["rows"] = std::move(rows);
  return answer;
}

constexpr EditorRequest kEditorRequests[] = {
    {{"describe", "main [files] [structured] [file] line column"}, Describe},
    {{"signature", "main [files] [structured] [file] line column"}, Signature},
    {{"complete", "main [files] [structured] [file] line column"}, Complete},
    {{"outline", "main [files] [structured] [file]"}, Outline},
    {{"definition", "main [files] [structured] [file] line column"}, Definition},
    {{"references", "main [files] [structured] [file] line column [declaration]"}, References},
    {{"rename", "main [files] [structured] [file] line column name"}, Rename},
    {{"tokens", "main [files] [structured] [file]"}, Tokens},
    {{"folds", "main [files] [structured] [file]"}, Folds},
    {{"hints", "main [files] [structured] [file]"}, Hints},
    {{"fixes", "main [files] [structured]"}, Fixes},
    {{"lower", "main [files] [structured]"}, Lower},
    {{"two_columns", "main [files] [structured]"}, TwoColumns},
};

}  // namespace

std::span<const EditorRequest> EditorRequests() { return kEditorRequests; }

}  // namespace oncard::session
