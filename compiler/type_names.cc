#include "compiler/type_names.h"

#include "compiler/header_types.h"
#include "compiler/parser.hh"
#include "compiler/parser_driver.h"

namespace oncard::compiler {
namespace {

using Kind = Parser::token;

class Marker {
 public:
  explicit Marker(std::vector<Token>& tokens) : tokens_(tokens) {}

  std::unordered_set<std::string_view> Run();

 private:
  // A name that is a type or, while a variable has it, none.
  struct Meaning {
    std::string_view name;
    bool is_type = false;
    int depth = 0;  // of the braces in which it holds
  };

  int KindAt(size_t i) const { return i < tokens_.size() ? tokens_[i].kind : Kind::kEnd; }
  bool IsType(std::string_view name) const;
  bool EndsType(size_t i) const;
  bool IsDeclared(size_t i) const;
  void VisitName(size_t i);
  void Define(size_t i);

  std::vector<Token>& tokens_;
  std::vector<Meaning> meanings_;
  std::unordered_set<std::string_view> all_;
  int braces_ = 0;
  int parens_ = 0;
  // Of the typedef that is read; -1: none is.
  int typedef_braces_ = -1;
};

bool Marker::IsType(std::string_view name) const {
  for (size_t i = meanings_.size(); i-- > 0;) {
    if (meanings_[i].name == name) return meanings_[i].is_type;
  }
  return false;
}

// Whether a token is one behind which a declared name may follow, and no other type.
bool Marker::EndsType(size_t i) const {
  return NamesType(KindAt(i)) || KindAt(i) == Kind::kCloseBrace;
}

// Whether the name at a place is one that a typedef declares.
bool Marker::IsDeclared(size_t i) const {
  if (typedef_braces_ != braces_) return false;
  const int next = KindAt(i + 1);
  const bool ends = next == Kind::kSemicolon || next == Kind::kComma ||
                    next == Kind::kOpenBracket || next == Kind::kCloseParen ||
                    next == Kind::kOpenParen;
  const int before = i > 0 ? KindAt(i - 1) : Kind::kEnd;
  const bool begins = parens_ == 0 ? EndsType(i - 1) || before == Kind::kComma ||
                                         before == Kind::kStar || before == Kind::kName
                                   : before == Kind::kStar;
  return ends && begins;
}

void Marker::Define(size_t i) {
  tokens_[i].kind = Kind::kName;
  meanings_.push_back({tokens_[i].text, true, braces_});
  all_.insert(tokens_[i].text);
}

void Marker::VisitName(size_t i) {
  const std::string_view name = tokens_[i].text;
  if (!all_.contains(name)) return;
  switch (i > 0 ? KindAt(i - 1) : Kind::kEnd) {
    case Kind::kDot:
    case Kind::kArrow:
    case Kind::kGoto:
    case Kind::kEnum:
    case Kind::kStruct:
      return;
    default:
      break;
  }
  if (i > 0 && EndsType(i - 1) && KindAt(i - 1) != Kind::kCloseBrace) {
    // `int word;` in a block whose program has a type `word`. A parameter holds in the body.
    meanings_.push_back({name, false, parens_ > 0 ? braces_ + 1 : braces_});
    return;
  }
  if (IsType(name)) tokens_[i].kind = Kind::kStructureName;
}

std::unordered_set<std::string_view> Marker::Run() {
  for (size_t i = 0; i < tokens_.size(); ++i) {
    switch (tokens_[i].kind) {
      case Kind::kTypedef:
        typedef_braces_ = braces_;
        break;
      case Kind::kOpenBrace:
        ++braces_;
        break;
      case Kind::kCloseBrace:
        while (!meanings_.empty() && meanings_.back().depth >= braces_ && braces_ > 0) {
          meanings_.pop_back();
        }
        --braces_;
        break;
      case Kind::kOpenParen:
        ++parens_;
        break;
      case Kind::kCloseParen:
        --parens_;
        break;
      case Kind::kSemicolon:
        if (typedef_braces_ == braces_) typedef_braces_ = -1;
        // The parameters of a prototype end with it.
        while (!meanings_.empty() && meanings_.back().depth > braces_ && parens_ == 0) {
          meanings_.pop_back();
        }
        break;
      case Kind::kInt:
        if (!TypeForHeaderType(tokens_[i].text).empty() && IsDeclared(i)) Define(i);
        break;
      case Kind::kName:
        if (IsDeclared(i)) {
          Define(i);
        } else {
          VisitName(i);
        }
        break;
      default:
        break;
    }
  }
  return std::move(all_);
}

}  // namespace

std::unordered_set<std::string_view> MarkTypeNames(std::vector<Token>& tokens) {
  return Marker(tokens).Run();
}

}  // namespace oncard::compiler
