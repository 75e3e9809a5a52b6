#include "session/comment_help.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/trim.h"
#include "compiler/dialect.h"

namespace oncard::session {
namespace {

using Json = nlohmann::ordered_json;

struct CommentWord {
  std::string_view name;
  std::string_view form;  // of the whole comment, after `//@`
  std::vector<std::string_view> values = {};
  Message meaning;
};

const std::vector<CommentWord>& CommentWords() {
  static const std::vector<CommentWord> words = {
      {.name = "always",
       .form = "always: CONDITION",
       .meaning = {"must hold in every state", "在每个状态下都须成立"}},
      {.name = "assert",
       .form = "assert: CONDITION",
       .meaning = {"must hold whenever a thread is about to execute the next statement; bare names "
                   "are that thread's locals first",
                   "每当线程即将执行下一条语句时须成立；名称先指该线程的局部变量"}},
      {.name = "deadlock",
       .form = "deadlock: any",
       .values = {"any", "none"},
       .meaning = {"with `any`, threads may all wait without executing",
                   "取 `any` 时，允许所有线程都在等待而不执行"}},
      {.name = "depth",
       .form = "depth: NUMBER",
       .meaning =
           {"above a function that calls itself, in structured C: how many of its calls run "
            "at the same time, at most; elsewhere, for all functions without their own",
            "结构化 C 中写在调用自身的函数上方：同时进行的调用的最大数目；写在别处时对所有没有自己"
            "深度的函数有效"}},
      {.name = "endless",
       .form = "endless",
       .meaning = {"the program is meant to run for ever: that it does not end is no failure",
                   "程序本应一直运行：不结束不算失败"}},
      {.name = "eventually",
       .form = "eventually: CONDITION",
       .meaning = {"must hold in some state of every run", "在每次运行的某个状态下须成立"}},
      {.name = "final",
       .form = "final: CONDITION",
       .meaning = {"must hold at the end of every run", "在每次运行结束时须成立"}},
      {.name = "init",
       .form = "init: NAME=NUMBER, ...",
       .meaning = {"values of globals before the start", "启动前全局变量的值"}},
      {.name = "input",
       .form = "input: NAME = FIRST..LAST, ...",
       .meaning = {"a choice: the global has any whole number of the range at the start; all are "
                   "explored, a run takes the smallest",
                   "选择：全局变量启动时可取范围内的任一整数；探索覆盖全部，运行取最小值"}},
      {.name = "leads",
       .form = "leads: CONDITION -> CONDITION",
       .meaning = {"after every state with the left side comes one with the right side, at some "
                   "time; an end without it is a failure",
                   "左侧成立的每个状态之后，右侧终会成立；未成立就结束即为失败"}},
      {.name = "livelock",
       .form = "livelock: any",
       .values = {"any", "none"},
       .meaning = {"with `any`, threads may go round for ever", "取 `any` 时，允许线程永远循环"}},
      {.name = "never",
       .form = "never: CONDITION",
       .meaning = {"must hold in no state", "在任何状态下都不得成立"}},
      {.name = "races",
       .form = "races: none",
       .values = {"none", "benign"},
       .meaning = {"`none`: a data race is a failure; `benign`: one that changes something",
                   "`none`：数据竞争即为失败；`benign`：有影响的数据竞争才是"}},
      {.name = "structured",
       .form = "structured",
       .meaning = {"in the first line: the program is structured C", "写在首行：程序为结构化 C"}},
      {.name = "sync",
       .form = "sync: NAME, ...",
       .meaning = {"globals that order threads; their accesses are no races",
                   "用于线程同步的全局变量；对它们的访问不算竞争"}},
      {.name = "within",
       .form = "within 5 ms: CONDITION -> CONDITION",
       .meaning = {"after every state with the left side comes one with the right side, after at "
                   "most this time of the card",
                   "左侧成立的每个状态之后，右侧须在此时间内成立（卡的时间）"}},
  };
  return words;
}

const CommentWord* FindWord(std::string_view name) {
  const auto found = std::ranges::find(CommentWords(), name, &CommentWord::name);
  return found == CommentWords().end() ? nullptr : &*found;
}

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

// The comment of a line, divided as far as it matters here; positions are in the line.
struct CommentLine {
  std::string_view text;
  size_t begin = 0;       // behind `//@`
  size_t colon = 0;       // the end of the line if there is none
  size_t word_begin = 0;  // of the word around the cursor
  size_t word_end = 0;
  std::string_view first;  // the word that says what it is

  bool in_head() const { return word_end <= colon; }
};

std::optional<CommentLine> ReadComment(const compiler::SourceFile& file, editor::Place place) {
  CommentLine line;
  line.text = file.Line(place.line);
  if (!Trim(line.text).starts_with(compiler::kToolComment)) return std::nullopt;
  line.begin = line.text.find(compiler::kToolComment) + compiler::kToolComment.size();
  const auto offset = static_cast<size_t>(line.text.data() - file.text().data());
  const size_t cursor = editor::OffsetOf(file, place) - offset;
  if (cursor < line.begin) return std::nullopt;
  line.colon = std::min(line.text.find(':', line.begin), line.text.size());
  line.word_begin = line.word_end = cursor;
  while (line.word_begin > line.begin && IsLetter(line.text[line.word_begin - 1])) {
    --line.word_begin;
  }
  while (line.word_end < line.text.size() && IsLetter(line.text[line.word_end])) ++line.word_end;
  size_t end = std::min(line.text.find_first_not_of(" \t", line.begin), line.text.size());
  const size_t first = end;
  while (end < line.text.size() && IsLetter(line.text[end])) ++end;
  line.first = line.text.substr(first, end - first);
  return line;
}

// True if the word around the cursor is the first of the comment, or could be.
bool IsFirst(const CommentLine& line) {
  return line.in_head() && Trim(line.text.substr(line.begin, line.word_begin - line.begin)).empty();
}

Json RangeOfWord(const compiler::SourceFile& file, editor::Place place, const CommentLine& line) {
  const auto begin = static_cast<uint32_t>(line.text.data() - file.text().data());
  const auto column = [&](size_t at) { return file.ColumnOf(begin + static_cast<uint32_t>(at)); };
  return {{"file", file.path()},
          {"line", place.line},
          {"column", column(line.word_begin)},
          {"end_line", place.line},
          {"end_column", column(line.word_end)}};
}

}  // namespace

std::optional<Json> CompleteComment(const compiler::SourceFile& file, editor::Place place,
                                    Language language) {
  const auto line = ReadComment(file, place);
  if (!line) return std::nullopt;
  Json items = Json::array();
  if (IsFirst(*line)) {
    for (const CommentWord& word : CommentWords()) {
      items.push_back({{"label", word.name},
                       {"kind", "key"},
                       {"detail", fmt::format("{} {}", compiler::kToolComment, word.form)},
                       {"documentation", word.meaning.In(language)}});
    }
  } else if (const CommentWord* word = FindWord(line->first); word != nullptr && !line->in_head()) {
    for (const std::string_view value : word->values) {
      items.push_back({{"label", value}, {"kind", "value"}});
    }
  }
  return Json{{"range", RangeOfWord(file, place, *line)}, {"items", std::move(items)}};
}

std::optional<Json> DescribeComment(const compiler::SourceFile& file, editor::Place place,
                                    Language language) {
  const auto line = ReadComment(file, place);
  if (!line || !IsFirst(*line)) return std::nullopt;
  const CommentWord* word = FindWord(line->first);
  if (word == nullptr) return std::nullopt;
  return Json{{"kind", "key"},
              {"name", word->name},
              {"markdown", fmt::format("`{} {}`\n\n{}\n", compiler::kToolComment, word->form,
                                       word->meaning.In(language))},
              {"range", RangeOfWord(file, place, *line)}};
}

}  // namespace oncard::session
