#include "editor/analysis.h"
#include "session/protocol_parts.h"

namespace oncard::session::schema {
namespace {

Members RangeMembers() {
  return {Has("line", Whole()), Has("column", Whole()), Has("end_line", Whole()),
          Has("end_column", Whole())};
}

Members FileRangeMembers() { return Members{Has("file", Text())} + RangeMembers(); }

Members FileMembers() {
  return ProgramMembers() +
         Members{MayHave("file", Text(), "A file of the program; without it the program.")};
}

Members MessageMembers() {
  return {Has("message", Text(), "In the language of the session."), Has("message_en", Text()),
          Has("message_zh", Text())};
}

Members ParameterMembers() {
  return {Has("name", Text()),
          Has("label", Text(), "Its declaration."),
          MayHave("type", Text()),
          MayHave("passing", Words({"input", "output", "unused"})),
          MayHave("unit", Text()),
          MayHave("range", Text()),
          MayHave("default", Text()),
          MayHave("note", Text(), "Unit, range and default in a line for people.")};
}

Json SymbolKinds() {
  using Kind = editor::Symbol::Kind;
  return Words(Names(Kind::kFunction, Kind::kMember, editor::KindName));
}

/// The kind of a symbol, or one of these.
Json SymbolKindOr(const std::vector<std::string_view>& others) {
  return OneOf({The("SymbolKind"), Words(others)});
}

}  // namespace

Members SourcePlaceMembers() {
  return FileMembers() + Members{Has("line", Whole()), Has("column", Whole())};
}

std::vector<Part> SourceParts() {
  return {
      {"SourceProject", "A file of a program.", Object(FileMembers())},
      {"SourcePlace", "A place in it. Lines and columns count from 1, columns in characters.",
       Object(SourcePlaceMembers())},
      {"Diagnostic", "A message of the compiler.",
       Object(Members{Has("code", Text()), Has("severity", Words({"error", "warning"})),
                      Has("slug", Text(), "The name of the code.")} +
              MessageMembers() + FileRangeMembers() +
              Members{Has("notes", ListOf(The("Note"))), Has("fixits", ListOf(The("Fixit")))})},
      {"Note", "More about a message; without a place if it is about none.",
       Object(MessageMembers() + Members{MayHave("file", Text()), MayHave("line", Whole()),
                                         MayHave("column", Whole()), MayHave("end_line", Whole()),
                                         MayHave("end_column", Whole())})},
      {"Fixit", "A text that replaces what is between two places.",
       Object(FileRangeMembers() + Members{Has("begin_offset", Whole(), "In bytes."),
                                           Has("end_offset", Whole()), Has("text", Text())})},
      {"FileRange", "A part of a file.", Object(FileRangeMembers())},
      {"SymbolKind", "What a name is.", SymbolKinds()},
      {"Parameter",
       "A parameter of a command, or of a function or macro, which has only a name and a label.",
       Object(ParameterMembers())},
      {"Description", "What the name or number at a place is.",
       Object({Has("kind", SymbolKindOr({"number", "key", "table"})),
               Has("markdown", Text(), "For people."), Has("range", The("FileRange")),
               MayHave("name", Text()), MayHave("declaration", Text()),
               MayHave("brief", Text(), "What a command does, in one line."),
               MayHave("callers", Text(), "Whose command it is."),
               MayHave("number", Whole(), "Of a command."),
               MayHave("source", Text(), "The manual that describes a command."),
               MayHave("parameters", ListOf(The("Parameter"))), MayHave("type", Text()),
               MayHave("function", Text(), "The function that the name belongs to."),
               MayHave("slot", Whole(), "Of the data page, or among the globals."),
               MayHave("value", Text(), "Of a number or constant."),
               MayHave("thread_function", Flag(), "Threads begin with it."), MayHave("hex", Text()),
               MayHave("raw", Whole(), "65536 times the value.")})},
      {"Signature", "The call around a place.",
       Object({Has("kind", Words({"command", "function", "macro"})), Has("name", Text()),
               Has("label", Text()), Has("parameters", ListOf(The("Parameter"))),
               MayHave("brief", Text()),
               MayHave("active", Whole(), "The parameter that the place belongs to, from 0."),
               Has("range", The("FileRange"), "The name.")})},
      {"Candidate", "What can be written at a place.",
       Object({Has("label", Text()),
               Has("kind", SymbolKindOr({"value", "type", "keyword", "directive", "key", "table"})),
               MayHave("detail", Text(), "Its declaration."), MayHave("documentation", Text()),
               MayHave("insert", Text(), "The text instead of the label.")})},
      {"Completion", "The candidates for a place.",
       Object({Has("range", The("FileRange"), "The word that a candidate replaces."),
               Has("items", ListOf(The("Candidate")), "The most likely first."),
               MayHave("argument",
                       Object(ParameterMembers() +
                              Members{Has("command", Text()), Has("index", Whole())}),
                       "The parameter of the command whose parentheses are around the place.")})},
      {"OutlineEntry", "What a file declares.",
       Object({Has("kind", The("SymbolKind")), Has("name", Text()), Has("detail", Text()),
               Has("range", The("FileRange")), Has("name_range", The("FileRange")),
               MayHave("thread_function", Flag()),
               MayHave("definition", Flag(), "False for a prototype."),
               MayHave("children", ListOf(The("OutlineEntry")),
                       "The parameters, variables and labels of a function.")})},
      {"Reference", "Where a name is used.",
       Object(FileRangeMembers() + Members{Has("access", Words({"declaration", "read", "write",
                                                                "read-write", "call"}))})},
      {"Edit", "A text that a part of a file gets.",
       Object(FileRangeMembers() + Members{Has("text", Text())})},
      {"Word", "A word of a file.",
       Object(Members{Has("kind", SymbolKindOr({"thread-function", "number", "string", "comment",
                                                "type", "keyword", "directive"}))} +
              RangeMembers() +
              Members{MayHave("declaration", Always(true)), MayHave("write", Always(true))})},
      {"Fold", "Lines that can be folded.",
       Object({Has("kind", Words({"function", "block", "comment", "directive"})),
               Has("line", Whole()), Has("end_line", Whole())})},
      {"Hint", "What a reader would have to look up, at a range without length.",
       Object(FileRangeMembers() + Members{Has("kind", Words({"argument", "member", "slot"})),
                                           MayHave("name", Text()), MayHave("unit", Text()),
                                           MayHave("slot", Whole()), Has("label", Text())})},
      {"Fixes", "A program after all fix-its, and what is left to be corrected.",
       Object({Has("compiled", Flag()), Has("diagnostics", ListOf(The("Diagnostic"))),
               Has("count", Whole()),
               Has("files", ListOf(The("SourceFile")), "Those that change.")})},
      {"Lowered", "What structured C becomes on the card; without a text if it does not compile.",
       Object(
           {Has("compiled", Flag()), Has("diagnostics", ListOf(The("Diagnostic"))),
            MayHave("text", Text()),
            MayHave("origins", ListOf(OrNull(Object({Has("file", Text()), Has("line", Whole())}))),
                    "Where each line of the text comes from.")})},
      {"TwoColumns",
       "Structured C beside what it becomes; without rows if it does not compile, or is none.",
       Object({Has("compiled", Flag()), Has("diagnostics", ListOf(The("Diagnostic"))),
               MayHave("rows", ListOf(The("TwoColumnsRow")))})},
      {"TwoColumnsRow", "A line of C, a line of the card's program without comments, or both.",
       Object({MayHave("file", Text(), "Of the line of C."), MayHave("line", Whole()),
               MayHave("text", Text(), "What stands in it."),
               MayHave("again", Always(true), "The line is in an earlier row, too."),
               MayHave("card", Text()), MayHave("card_line", Whole(), "Where `card` stands.")})},
  };
}

}  // namespace oncard::session::schema
