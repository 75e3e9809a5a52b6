// The syntax tree of a program. It is deliberately richer than the language: it can represent
// nearly all statements and expressions of C, so that the checker can say for each unsupported
// construct what to write instead. What only structured C has (compiler/dialect.h) is marked so.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/diagnostic.h"
#include "compiler/literal.h"

namespace oncard::compiler {

/// A token, or a directive. `text` points into the text of its file.
struct Token {
  int kind = 0;  ///< Parser::token
  SourceRange range;
  std::string_view text;
  Literal literal;  ///< of a number
  int macro = -1;   ///< of a #define: index into Tree::macros
  bool on_new_line = false;
};

/// What is nested deeper is rejected with MP130.
inline constexpr int kDepthMax = 200;
/// Operators in a row, as in a sum, and branches in a row, as in `else if`, are not nested, but
/// each is one level of the tree. Trees are processed recursively; higher ones are rejected with
/// MP138.
inline constexpr int kHeightMax = 1000;

/// How deep a tree is nested, and how many levels it has above its leaves.
struct Levels {
  int depth = 1;
  int height = 0;
};

struct Expression;
using ExpressionPtr = std::unique_ptr<Expression>;
struct TypeName;
using TypeNamePtr = std::unique_ptr<TypeName>;
struct Statement;
using StatementPtr = std::unique_ptr<Statement>;

struct Expression {
  enum class Kind : uint8_t {
    kName,         ///< text
    kLiteral,      ///< literal
    kString,       ///< "..." or '.'
    kIndex,        ///< operands: array, index
    kMember,       ///< operands: structure; text is the member, op `.` or `->`
    kUnary,        ///< op, operands: one
    kPostfix,      ///< op `++` or `--`, operands: one
    kBinary,       ///< op, operands: two
    kAssign,       ///< op `=`, operands: target, value
    kCompound,     ///< op such as `+=`, operands: target, value
    kCast,         ///< type; text is the type if it is one word; operands: one
    kSizeof,       ///< operands: one, or type; structured C
    kCall,         ///< operands: callee, arguments
    kConditional,  ///< operands: three
    kComma,        ///< operands: two
    kParen,        ///< operands: one
    kBraces,       ///< { a, b }: an array's initialiser, nested for more dimensions
    kDesignated,  ///< in braces `[1] = 2`, operands: value, index, perhaps the last one of a range;
                  ///< or `.m = 2`, text is the member, operands: value; structured C
    kCompoundLiteral,  ///< (struct s){1, 2}: type, operands: the braces; structured C
    kError             ///< reported already
  };
  Kind kind = Kind::kError;
  SourceRange range;
  SourceRange op_range;  ///< of the operator, or of a member's name
  std::string_view op;
  std::string_view text;
  Literal literal;
  TypeNamePtr type;
  std::vector<ExpressionPtr> operands;
  Levels levels;
};

/// A constant of an enum.
struct Enumerator {
  SourceRange range;
  SourceRange name_range;
  std::string_view name;
  ExpressionPtr value;  ///< nullptr: one more than the previous one
};

/// `enum Name` or `enum Name { A, B = 4 }`; structured C.
struct Enumeration {
  SourceRange range;
  SourceRange name_range;
  std::string_view name;  ///< empty for an anonymous one
  bool defined = false;   ///< has braces
  std::vector<Enumerator> enumerators;
};

/// `struct Name` or `struct Name { int a; }`; structured C.
struct StructSpecifier {
  SourceRange range;
  SourceRange name_range;
  std::string_view name;              ///< empty for an anonymous one
  std::string tag;                    ///< `struct Name`, which no variable is called
  bool defined = false;               ///< has braces
  std::vector<StatementPtr> members;  ///< declarations
  Levels levels;
};

/// The words before a declared name, such as `unsigned long`.
struct Specifiers {
  SourceRange range;
  std::vector<const Token*> words;             ///< without those of the enumeration or structure
  std::unique_ptr<Enumeration> enumeration;    ///< structured C
  std::unique_ptr<StructSpecifier> structure;  ///< structured C
};

/// A type without a name, as in `(double)` and `sizeof(int[4])`.
struct TypeName {
  SourceRange range;
  Specifiers specifiers;
  bool pointer = false;
  std::vector<ExpressionPtr> sizes;  ///< nullptr for `[]`
};

struct Declarator {
  SourceRange range;  ///< from the name to the end of the initialiser
  SourceRange name_range;
  std::string_view name;
  SourceRange head;                  ///< from the name to the last dimension
  int pointer = 0;                   ///< stars before the name
  std::vector<ExpressionPtr> sizes;  ///< nullptr for `[]`
  ExpressionPtr initialiser;
};

struct ParameterDeclaration {
  SourceRange range;
  Specifiers specifiers;
  Declarator declarator;  ///< no name: the type alone
};

struct Function {
  SourceRange header;
  SourceRange name_range;
  std::string_view name;
  Specifiers specifiers;
  bool pointer = false;
  std::vector<ParameterDeclaration> parameters;
  std::vector<StatementPtr> body;
  SourceRange open_brace;
  SourceRange close_brace;
  bool prototype = false;  ///< `int f();`
  bool mended = false;     ///< reported: the types of its parameters stand before the body
  /// The others of `int f(), g();`, in structured C.
  std::vector<std::unique_ptr<Function>> others;
};

struct Statement {
  enum class Kind : uint8_t {
    kEmpty,
    kExpression,   ///< value
    kDeclaration,  ///< specifiers, declarators; of an enum or struct, there may be none
    kIf,           ///< value, body, else_body
    kWhile,        ///< value, body
    kDo,           ///< body, value
    kFor,          ///< initial, value, step, body
    kSwitch,       ///< value, body
    kCase,         ///< value, and last of a range `case 1 ... 5:` (structured C)
    kDefault,
    kLabel,   ///< name
    kGoto,    ///< name
    kReturn,  ///< value or nullptr
    kBreak,
    kContinue,
    kBlock,       ///< items; also labels with their statement as the body of an `if` or a loop
    kFunction,    ///< function
    kMacro,       ///< macro
    kStrayBrace,  ///< `}` outside a function
    kError        ///< reported already
  };
  Kind kind = Kind::kEmpty;
  SourceRange range;
  SourceRange keyword;  ///< the first word, or the `while` of a `do`
  SourceRange other;    ///< `else`
  std::string_view name;
  SourceRange name_range;
  ExpressionPtr value;
  ExpressionPtr last;
  ExpressionPtr step;
  StatementPtr initial;
  StatementPtr body;
  StatementPtr else_body;
  std::vector<StatementPtr> items;
  Specifiers specifiers;
  std::vector<Declarator> declarators;
  std::unique_ptr<Function> function;
  int macro = -1;
  Levels levels;
};

/// A #define.
struct Macro {
  std::string_view name;
  SourceRange name_range;
  Literal value;
};

/// A whole program: the top-level items in order, including those of included files.
struct Tree {
  std::vector<StatementPtr> items;
  std::vector<Macro> macros;
};

}  // namespace oncard::compiler
