// Declarations: types, dimensions, scopes, and the names that variables get in the output.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/header_types.h"
#include "compiler/lowering/lowerer.h"
#include "compiler/parser.hh"
#include "vm/limits.h"

namespace oncard::compiler::lowering {
namespace {

// What the words of a declaration say about a scalar type. The front end has refused all that have
// no meaning.
struct Words {
  std::string_view base;
  bool is_short = false;
  bool is_unsigned = false;
};

BasicType TypeOfWords(const Words& words) {
  if (words.base == "char") {
    return words.is_unsigned ? BasicType::kUnsignedChar : BasicType::kChar;
  }
  if (words.base == "void") return BasicType::kVoid;
  if (words.base == "bool" || words.base == "_Bool") return BasicType::kBool;
  if (words.base == "double") return BasicType::kDouble;
  if (words.is_short) return words.is_unsigned ? BasicType::kUnsignedShort : BasicType::kShort;
  return words.is_unsigned ? BasicType::kUnsigned : BasicType::kInt;
}

int64_t SizeOfAll(const std::vector<int64_t>& dimensions) {
  int64_t size = dimensions.empty() ? 0 : 1;
  for (const int64_t dimension : dimensions) size *= dimension;
  return size;
}

// What a variable of a type has variables of the card for. The members of a structure of the card
// that is repeated are arrays.
std::vector<Leaf> LeavesIn(const Type& type, const std::vector<int64_t>& dimensions) {
  if (type.own == nullptr) {
    Leaf leaf;
    leaf.type = type;
    return {leaf};
  }
  std::vector<Leaf> leaves = type.own->leaves;
  for (Leaf& leaf : leaves) {
    if (leaf.card == nullptr || (dimensions.empty() && !leaf.is_array)) continue;
    const std::string_view member = leaf.card->members[static_cast<size_t>(leaf.member)].name;
    leaf.name = leaf.name.empty() ? std::string(member) : JoinNames(leaf.name, member);
    leaf.written += fmt::format(".{}", member);
    leaf.card = nullptr;
    leaf.member = 0;
  }
  return leaves;
}

// Of the members of a structure of the card the first one has its name.
bool IsNamed(const Leaf& leaf) { return leaf.member == 0; }

// The variable of the card for a leaf of a variable that C calls `written`.
Variable VariableFor(const Leaf& leaf, const std::vector<int64_t>& dimensions,
                     std::string_view written, std::string name) {
  Variable variable;
  variable.type = DataTypeOf(leaf.type.basic);
  variable.structure = leaf.card;
  variable.member = leaf.member;
  const int64_t structures = SizeOfAll(dimensions);
  if (structures != 0 || leaf.is_array) {
    variable.size = static_cast<int>(std::max(structures, int64_t{1}) * leaf.size);
  }
  if (!leaf.written.empty() || dimensions.size() > 1) {
    variable.written = fmt::format("{}{}{}", written, SpellSizes(dimensions), leaf.written);
  }
  variable.name = std::move(name);
  return variable;
}

Message WhyNoExtern() {
  return MakeMessage(
      "it is declared 'extern' and defined nowhere in the program; leave 'extern' out",
      "它声明为 'extern'，而程序中没有定义；请去掉 'extern'");
}

}  // namespace

bool Lowerer::HasWord(const Specifiers& specifiers, std::string_view word) const {
  return std::any_of(specifiers.words.begin(), specifiers.words.end(),
                     [word](const Token* token) { return token->text == word; });
}

Type Lowerer::ResolveType(const Specifiers& specifiers) const {
  return TypeFrom(specifiers, nullptr);
}

// The type of a function's result or parameter, whose names are global also where it is inlined.
Type Lowerer::ResolveGlobalType(const Specifiers& specifiers) const {
  return TypeFrom(specifiers, scopes_.data());
}

// Names of types are those of the scope, or those that are visible.
Type Lowerer::TypeFrom(const Specifiers& specifiers, const Scope* scope) const {
  constexpr std::string_view kBases[] = {"char", "double", "void", "bool", "_Bool"};
  Type type;
  Words words;
  const Symbol* named = nullptr;
  if (specifiers.structure != nullptr) {
    type.basic = BasicType::kStructure;
    type.own = FindStructure(*specifiers.structure, scope);
    type.is_const = HasWord(specifiers, "const");
    return type;
  }
  for (const Token* token : specifiers.words) {
    const std::string_view word = token->text;
    if (token->kind == Parser::token::kStructureName || token->kind == Parser::token::kInt) {
      const Symbol* symbol = Lookup(word);
      if (scope != nullptr) {
        const auto found = scope->find(word);
        symbol = found != scope->end() ? &found->second : nullptr;
      }
      if (symbol != nullptr && symbol->kind == Symbol::Kind::kType) named = symbol;
    }
    type.is_const |= word == "const";
    const std::string_view header_type = TypeForHeaderType(word);
    words.is_short |= word == "short" || header_type.ends_with("short");
    words.is_unsigned |= word == "unsigned" || header_type.starts_with("unsigned");
    if (header_type.ends_with("char")) words.base = "char";
    if (std::find(std::begin(kBases), std::end(kBases), word) != std::end(kBases)) {
      words.base = word;
    }
    const auto card = card_structures_.find(options_.catalogue->FindStructure(word));
    if (card != card_structures_.end()) type.own = &card->second;
  }
  if (named != nullptr) {
    const bool is_const = type.is_const || named->type.is_const;
    type = named->type;
    type.is_const = is_const;
    type.rows = named->dimensions.empty() ? nullptr : &named->dimensions;
    return type;
  }
  type.basic = type.own != nullptr ? BasicType::kStructure : TypeOfWords(words);
  return type;
}

void Lowerer::Define(std::string_view name, Symbol symbol) {
  Scope& scope = scopes_.back();
  symbol.order = order_;
  const auto [entry, added] = scope.emplace(name, symbol);
  if (added) return;
  Report(Code::kRedefinition, symbol.range, name);
}

const Lowerer::Symbol* Lowerer::Lookup(std::string_view name) const {
  if (frame_ != nullptr) {
    for (size_t i = scopes_.size(); i > frame_->scope_base; --i) {
      const auto found = scopes_[i - 1].find(name);
      if (found != scopes_[i - 1].end()) return &found->second;
    }
  }
  const auto found = scopes_[0].find(name);
  if (found == scopes_[0].end()) return nullptr;
  const Symbol& symbol = found->second;
  const bool later = frame_ != nullptr && symbol.kind != Symbol::Kind::kFunction &&
                     symbol.order > frame_->info->order;
  return later ? nullptr : &symbol;
}

// How a local structure is called: by its name in C, or with a number if another one of the thread
// function has it.
std::string Lowerer::NewWrittenName(std::string_view wish) {
  int& uses = written_names_[std::string(wish)];
  if (++uses == 1) return std::string(wish);
  for (;; ++uses) {
    std::string name = fmt::format("{}_{}", wish, uses);
    if (written_names_.try_emplace(name, 1).second) return name;
  }
}

// A structure becomes a variable for each leaf; the result is the first one.
int Lowerer::NewVariable(Variable::Role role, std::string_view wish, const Type& type,
                         const std::vector<int64_t>& dimensions, SourceRange range) {
  const int first = static_cast<int>(program_.variables.size());
  const bool own = type.own != nullptr && (type.own->card == nullptr || !dimensions.empty());
  const std::string written = own ? NewWrittenName(wish) : std::string();
  for (const Leaf& leaf : LeavesIn(type, dimensions)) {
    const std::string name = IsNamed(leaf) ? names_.Make(JoinNames(wish, leaf.name)) : "";
    if (!name.empty()) local_names_.insert(name);
    Variable variable = VariableFor(leaf, dimensions, own ? written : name, name);
    variable.role = role;
    variable.group = frame_ != nullptr ? frame_->group : 0;
    variable.range = range;
    program_.variables.push_back(std::move(variable));
  }
  return first;
}

int Lowerer::NewGlobal(const std::string& name, const Type& type,
                       const std::vector<int64_t>& dimensions, SourceRange range) {
  const int first = static_cast<int>(program_.variables.size());
  for (const Leaf& leaf : LeavesIn(type, dimensions)) {
    std::string own_name = IsNamed(leaf) ? JoinNames(name, leaf.name) : "";
    if (!leaf.name.empty() && IsNamed(leaf)) own_name = NewGlobalName(own_name);
    Variable variable = VariableFor(leaf, dimensions, name, std::move(own_name));
    variable.role = Variable::Role::kGlobal;
    variable.is_table = type.is_const && variable.size > 0;
    variable.range = range;
    if (IsNamed(leaf)) program_.globals.push_back(static_cast<int>(program_.variables.size()));
    program_.variables.push_back(std::move(variable));
  }
  return first;
}

// A name that no local has either.
std::string Lowerer::NewGlobalName(std::string_view wish) {
  std::string name;
  do {
    name = global_names_.Make(wish);
  } while (local_names_.contains(name));
  return name;
}

// A function that is inlined twice has its variables once.
int Lowerer::VariableOf(const void* declaration, Variable::Role role, std::string_view name,
                        const Type& type, const std::vector<int64_t>& dimensions,
                        SourceRange range) {
  const auto found = variables_.find(declaration);
  if (found != variables_.end()) return found->second;
  const int variable =
      NewVariable(role, frame_->prefix + std::string(name), type, dimensions, range);
  variables_.emplace(declaration, variable);
  return variable;
}

// Whether a parameter stands for a number or an array of the caller: `int a[4]`, `int *a`.
bool Lowerer::IsReference(const Declarator& parameter, const Type& type) {
  return !parameter.sizes.empty() || parameter.pointer > 0 || type.rows != nullptr;
}

std::optional<std::vector<int64_t>> Lowerer::Dimensions(const Declarator& declarator,
                                                        const Type& type) {
  std::vector<int64_t> dimensions;
  int64_t elements = 1;  // of one row, if the number of rows is not known
  if (declarator.pointer > 0) dimensions.push_back(0);
  for (size_t i = 0; i < declarator.sizes.size(); ++i) {
    const Expression* size = declarator.sizes[i].get();
    if (size == nullptr) {
      if (i > 0) {
        Report(Code::kNotLowered, declarator.head,
               MakeMessage("a second '[]' without a size", "第二个没有长度的 '[]'"),
               MakeMessage("only the first size can be left out", "只有第一个长度可以省略"));
        return std::nullopt;
      }
      dimensions.push_back(0);
      continue;
    }
    const std::optional<TypedConstant> value = Evaluate(*size);
    if (!value || !IsInteger(value->type)) {
      Report(Code::kVariableSize, size->range, declarator.name);
      return std::nullopt;
    }
    if (value->value.integer < 1 || value->value.integer > vm::kSlotCount) {
      Report(Code::kArraySize, size->range, declarator.name, value->value.Text(),
             int64_t{vm::kSlotCount});
      return std::nullopt;
    }
    dimensions.push_back(value->value.integer);
    elements *= value->value.integer;
    if (elements > vm::kSlotCount) {
      Report(Code::kArraySize, size->range, declarator.name, std::to_string(elements),
             int64_t{vm::kSlotCount});
      return std::nullopt;
    }
  }
  if (type.rows == nullptr) return dimensions;
  for (const int64_t size : *type.rows) elements *= size;
  if (elements > vm::kSlotCount) {
    Report(Code::kArraySize, declarator.head, declarator.name, std::to_string(elements),
           int64_t{vm::kSlotCount});
    return std::nullopt;
  }
  dimensions.insert(dimensions.end(), type.rows->begin(), type.rows->end());
  return dimensions;
}

// `typedef int name[4];`
void Lowerer::DefineType(const Declarator& declarator, const Type& type) {
  Symbol symbol;
  symbol.kind = Symbol::Kind::kType;
  symbol.type = type;
  symbol.type.rows = nullptr;
  symbol.range = declarator.name_range;
  const std::optional<std::vector<int64_t>> dimensions = Dimensions(declarator, type);
  if (dimensions) symbol.dimensions = *dimensions;
  if (dimensions && !dimensions->empty() && dimensions->front() == 0) {
    Report(Code::kVariableSize, declarator.head, declarator.name);
  }
  if (declarator.initialiser != nullptr) {
    Report(Code::kNotForTheCard, declarator.initialiser->range,
           Source(declarator.initialiser->range),
           MakeMessage("a type has no value; declare a variable", "类型没有值；请声明变量"));
  }
  // C lets it be said twice.
  const auto known = scopes_.back().find(declarator.name);
  const bool again = known != scopes_.back().end() && known->second.kind == Symbol::Kind::kType &&
                     known->second.type.basic == type.basic && known->second.type.own == type.own &&
                     known->second.type.is_const == type.is_const &&
                     known->second.dimensions == symbol.dimensions;
  if (!again) Define(declarator.name, std::move(symbol));
}

// The constants of an enum, in the scope that declares it.
void Lowerer::DefineEnumeration(const Enumeration& enumeration) {
  TypedConstant next;
  for (const Enumerator& enumerator : enumeration.enumerators) {
    if (enumerator.value != nullptr) {
      const std::optional<TypedConstant> value = Evaluate(*enumerator.value);
      if (value && IsInteger(value->type)) {
        next = *ConvertConstant(*value, BasicType::kInt);
      } else {
        Report(Code::kConstantNeeded, enumerator.value->range, Source(enumerator.value->range));
      }
    }
    Symbol symbol;
    symbol.kind = Symbol::Kind::kConstant;
    symbol.range = enumerator.name_range;
    symbol.constant = next;
    Define(enumerator.name, std::move(symbol));
    next.value.integer = ConvertInteger(next.value.integer + 1, BasicType::kInt);
  }
}

// An enum or a structure whose definition is a type.
void Lowerer::DefineTypesOf(const Specifiers& specifiers) {
  const Enumeration* const enumeration = specifiers.enumeration.get();
  if (enumeration != nullptr && enumeration->defined) DefineEnumeration(*enumeration);
  const StructSpecifier* const structure = specifiers.structure.get();
  if (structure != nullptr && structure->defined) DefineStructure(*structure);
}

void Lowerer::LowerDeclaration(const Statement& statement) {
  DefineTypesOf(statement.specifiers);
  if (statement.declarators.empty()) return;
  const Type type = ResolveType(statement.specifiers);
  for (const Declarator& declarator : statement.declarators) {
    if (HasWord(statement.specifiers, "typedef")) {
      DefineType(declarator, type);
      continue;
    }
    if (DeclareConstant(declarator, type)) continue;
    const bool is_extern = HasWord(statement.specifiers, "extern");
    if (frame_ == nullptr) {
      DeclareGlobal(declarator, type, is_extern);
    } else if (is_extern) {
      DeclareExtern(declarator);
    } else {
      DeclareLocal(declarator, type, HasWord(statement.specifiers, "static"));
    }
  }
}

// A const number with a known value takes no storage.
bool Lowerer::DeclareConstant(const Declarator& declarator, const Type& type) {
  if (!type.is_const || !IsArithmetic(type.basic) || !declarator.sizes.empty() ||
      type.rows != nullptr || declarator.initialiser == nullptr) {
    return false;
  }
  const std::optional<TypedConstant> value = Evaluate(*declarator.initialiser);
  const std::optional<TypedConstant> converted =
      value ? ConvertConstant(*value, type.basic) : std::nullopt;
  if (!converted) return false;
  Symbol symbol;
  symbol.kind = Symbol::Kind::kConstant;
  symbol.type = type;
  symbol.range = declarator.name_range;
  symbol.constant = *converted;
  const auto known = frame_ == nullptr ? scopes_[0].find(declarator.name) : scopes_[0].end();
  if (known != scopes_[0].end() && known->second.is_extern) {
    symbol.order = known->second.order;
    known->second = std::move(symbol);
    return true;
  }
  Define(declarator.name, std::move(symbol));
  return true;
}

// `[]` has as many rows as there are values for; in `extern int a[];` a later declaration says how
// many.
void Lowerer::SetDimensions(const Declarator& declarator, bool is_extern, Symbol& symbol) {
  std::optional<std::vector<int64_t>> dimensions = Dimensions(declarator, symbol.type);
  symbol.type.rows = nullptr;
  symbol.invalid = !dimensions || !IsComplete(symbol.type, declarator.name, declarator.name_range);
  if (symbol.invalid) return;
  symbol.dimensions = std::move(*dimensions);
  const int64_t values = Width({symbol.type, symbol.dimensions});
  if (values > vm::kSlotCount) {
    symbol.invalid = true;
    Report(Code::kArraySize, declarator.head, declarator.name, std::to_string(values),
           int64_t{vm::kSlotCount});
  }
  if (symbol.dimensions.empty() || symbol.invalid) return;
  if (symbol.dimensions[0] != 0 || (is_extern && declarator.initialiser == nullptr)) return;
  const std::optional<Elements> elements = ElementsOf(declarator, symbol);
  symbol.invalid = !elements;
  if (!elements) return;
  const int64_t width = Width(PartOf({symbol.type, symbol.dimensions}, 0).shape);
  symbol.dimensions[0] = (static_cast<int64_t>(elements->size()) + width - 1) / width;
}

// Globals and thread functions keep their names. All others are abbreviated in the output.
void Lowerer::CheckNameLength(std::string_view name, SourceRange range) {
  if (name.size() <= vm::kNameLengthMax) return;
  Report(Code::kNameTooLong, range, name, static_cast<int64_t>(name.size()),
         int64_t{vm::kNameLengthMax});
}

// Whether a declaration of a global may stand after another one, as `int g;` after `extern int g;`.
bool Lowerer::Redeclares(const Symbol& first, const Symbol& symbol) {
  const std::vector<int64_t>& before = first.dimensions;
  const std::vector<int64_t>& now = symbol.dimensions;
  const bool same_type = first.kind == Symbol::Kind::kVariable && !first.invalid &&
                         first.type.basic == symbol.type.basic && first.type.own == symbol.type.own;
  if (!same_type || before.size() != now.size()) return false;
  for (size_t i = 0; i < now.size(); ++i) {
    if (before[i] != now[i] && before[i] != 0 && now[i] != 0) return false;
  }
  return true;
}

void Lowerer::DeclareGlobal(const Declarator& declarator, const Type& type, bool is_extern) {
  Symbol symbol;
  symbol.type = type;
  symbol.range = declarator.name_range;
  symbol.offset = IntOperand(0);
  symbol.is_extern = is_extern && declarator.initialiser == nullptr;
  SetDimensions(declarator, is_extern, symbol);
  const auto known = scopes_[0].find(declarator.name);
  // C's tentative definitions: `extern int g;` and `int g;` are one variable.
  const bool again = known != scopes_[0].end() && !symbol.invalid &&
                     Redeclares(known->second, symbol) &&
                     !(known->second.initialised && declarator.initialiser != nullptr);
  if (!again) {
    CheckNameLength(declarator.name, declarator.name_range);
    global_names_.Reserve(declarator.name);
  }
  Symbol& first = again ? known->second : symbol;
  if (again && !first.dimensions.empty()) {
    first.dimensions[0] = std::max(first.dimensions[0], symbol.dimensions[0]);
  }
  first.is_extern &= symbol.is_extern;
  if (first.variable < 0 && !first.is_extern && !first.invalid) {
    first.variable = NewGlobal(std::string(declarator.name), type, first.dimensions, first.range);
  }
  const bool initialise = !first.invalid && declarator.initialiser != nullptr;
  first.initialised |= initialise;
  const Symbol declared = first;
  if (!again) Define(declarator.name, declared);
  if (initialise) InitialiseGlobal(declarator, declared);
}

// `extern int g;` in a function: the global, whatever else is called so there.
void Lowerer::DeclareExtern(const Declarator& declarator) {
  const auto global = scopes_[0].find(declarator.name);
  if (global == scopes_[0].end()) {
    Report(Code::kNotForTheCard, declarator.name_range, declarator.name, WhyNoExtern());
    return;
  }
  if (declarator.initialiser != nullptr) {
    Report(Code::kNotForTheCard, declarator.initialiser->range,
           Source(declarator.initialiser->range),
           MakeMessage("give the value where '{0}' is defined, outside the functions",
                       "请在函数之外定义 '{0}' 的地方给出初值", declarator.name));
  }
  Symbol symbol = global->second;
  Define(declarator.name, std::move(symbol));
}

// False for a symbol of which nothing more is said: with an error, or declared and not defined,
// which is reported.
bool Lowerer::IsUsable(const Symbol& symbol, std::string_view name) {
  if (symbol.is_extern) Report(Code::kNotForTheCard, symbol.range, name, WhyNoExtern());
  if (symbol.kind == Symbol::Kind::kType) {
    Report(Code::kNotForTheCard, symbol.range, name,
           MakeMessage("a type and a variable have this name; choose another one",
                       "类型和变量同用此名称；请另取一个名称"));
    return false;
  }
  return !symbol.invalid && !symbol.is_extern;
}

void Lowerer::DeclareLocal(const Declarator& declarator, const Type& type, bool is_static) {
  Symbol symbol;
  symbol.type = type;
  symbol.range = declarator.name_range;
  symbol.offset = IntOperand(0);
  SetDimensions(declarator, false, symbol);
  if (symbol.invalid) {
    Define(declarator.name, std::move(symbol));
    return;
  }
  if (is_static) {
    const auto [entry, added] = statics_.try_emplace(&declarator, -1);
    if (added) {
      // The name says whose it is: it is a global now.
      const std::string wish = fmt::format("{}_{}", frame_->info->syntax->name, declarator.name);
      entry->second =
          NewGlobal(NewGlobalName(wish), type, symbol.dimensions, declarator.name_range);
      for (size_t i = static_cast<size_t>(entry->second); i < program_.variables.size(); ++i) {
        names_.Reserve(program_.variables[i].name);
      }
      symbol.variable = entry->second;
      if (declarator.initialiser != nullptr) InitialiseGlobal(declarator, symbol);
    }
    symbol.variable = entry->second;
    Define(declarator.name, std::move(symbol));
    return;
  }
  symbol.variable = VariableOf(&declarator, Variable::Role::kLocal, declarator.name, type,
                               symbol.dimensions, declarator.name_range);
  if (instance_ >= 0) {
    const int block = out_->instances[static_cast<size_t>(instance_)].block;
    const auto first = program_.variables.begin() + symbol.variable;
    std::for_each(first, first + LeavesOf(type),
                  [block](Variable& variable) { variable.block = block; });
  }
  // In C the scope of a name begins before its initial value.
  Define(declarator.name, symbol);
  if (declarator.initialiser != nullptr) InitialiseLocal(declarator, symbol);
}

}  // namespace oncard::compiler::lowering
