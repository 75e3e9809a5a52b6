// Declarations: macros, variables, functions and their parameters.
#include <algorithm>

#include "compiler/declarations.h"
#include "compiler/rewriter.h"
#include "vm/limits.h"

namespace oncard::compiler {
namespace {

using vm::DataType;

bool IsWordOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

Declarations::DeclaredType Declarations::ResolveType(const Specifiers& specifiers) {
  DeclaredType type;
  type.words = context_.Source(specifiers.range);
  std::string spelled;
  bool foreign = specifiers.words.size() > 1;
  bool is_double = false;
  bool known = false;
  for (const Token* word : specifiers.words) {
    if (!spelled.empty()) spelled += ' ';
    spelled += word->text;
    if (IsWordOf(word->text, {"float", "double"})) is_double = true;
    if (IsWordOf(word->text, {"float", "char", "bool", "_Bool", "unsigned", "signed", "static",
                              "const", "extern"})) {
      foreign = known = true;
    }
    if (IsWordOf(word->text, {"int", "long", "short", "double", "void"})) known = true;
    if (word->text == "void") type.is_void = true;
    const gtcalls::Structure* structure = context_.catalogue.FindStructure(word->text);
    if (structure != nullptr && structure->in_motion_program) type.structure = structure;
  }
  if (!known && type.structure == nullptr) {
    const bool skipped = context_.skipped_names.contains(spelled);
    if (!skipped) {
      Diagnostic& diagnostic = context_.reporter.Report(
          Code::kNotAType, specifiers.range, ToMessage(fmt::format("'{}'", spelled)),
          std::string_view("int, double, long, short, TTrapPrm, TJogPrm, TPid"));
      Nearest nearest(spelled);
      for (const std::string_view candidate : {"int", "double", "long", "short", "void", "TTrapPrm",
                                               "TJogPrm", "TPid", "return", "goto", "if"}) {
        nearest.Add(candidate);
      }
      if (!nearest.best().empty()) {
        AddNote(diagnostic,
                MakeMessage("did you mean '{0}'?", "您是否想写 '{0}'？", nearest.best()));
        Replace(diagnostic, specifiers.range, std::string(nearest.best()));
      }
    }
    return type;
  }
  type.type = is_double ? DataType::kDouble : DataType::kInt;
  type.valid = true;
  if (foreign) {
    const std::string_view plain = type.structure != nullptr ? type.structure->name
                                   : type.is_void            ? std::string_view("void")
                                   : is_double               ? std::string_view("double")
                                                             : std::string_view("int");
    const Token* storage = nullptr;
    for (const Token* word : specifiers.words) {
      const bool is_const = word->text == "const";
      const bool is_static = IsWordOf(word->text, {"static", "extern"});
      type.is_const = type.is_const || is_const;
      type.is_static = type.is_static || is_static;
      if (is_const || is_static) storage = word;
    }
    type.report =
        storage != nullptr
            ? &context_.reporter.Report(Code::kReservedWord, storage->range, storage->text,
                                        MakeMessage("leave it out", "请去掉它"))
            : &context_.reporter.Report(Code::kForeignType, specifiers.range, spelled, plain);
    type.plain = plain;
  }
  return type;
}

// Reports a name that is already in use. Locals of inner blocks and locals with the name of a
// global are renamed, for which their declarator is needed.
Declarations::NameUse Declarations::ReportTakenName(std::string_view name, SourceRange range,
                                                    bool local, const Declarator* declarator) {
  const Entity* same = nullptr;
  if (local && context_.function != nullptr) same = context_.function->locals.Find(name);
  const Entity* global = context_.globals.Find(name);
  if (same == nullptr && !local) same = global;
  if (same != nullptr && local) {
    const auto open = context_.function->open_names.find(name);
    if (open == context_.function->open_names.end() ||
        open->second + 1 < context_.function->blocks.size()) {
      Diagnostic& diagnostic = context_.reporter.Report(
          Code::kShadowing, range, name,
          MakeMessage("another variable of the function", "函数中另一个变量"));
      AddNote(diagnostic, same->range, MakeMessage("it is defined here", "其定义在此处"));
      if (declarator != nullptr) Rename(*declarator, diagnostic);
      return NameUse::kHidesAnother;
    }
  }
  if (same != nullptr) {
    AddNote(context_.reporter.Report(Code::kRedefinition, range, name), same->range,
            MakeMessage("the first definition is here", "首次定义在此处"));
    return NameUse::kTaken;
  }
  if (context_.catalogue.Find(name) != nullptr) {
    AddNote(context_.reporter.Report(Code::kRedefinition, range, name),
            MakeMessage("'{0}' is a GT command", "'{0}' 是 GT 指令", name));
    return NameUse::kTaken;
  }
  if (local && global != nullptr) {
    const bool variable = global->kind == Entity::Kind::kVariable;
    Diagnostic& diagnostic = context_.reporter.Report(
        Code::kShadowing, range, name,
        variable ? MakeMessage("a global variable", "全局变量") : DescribeEntity(*global));
    AddNote(diagnostic, global->range, MakeMessage("it is defined here", "其定义在此处"));
    if (declarator != nullptr && global->kind != Entity::Kind::kMacro) {
      Rename(*declarator, diagnostic);
    }
    return NameUse::kHidesAnother;
  }
  return NameUse::kFree;
}

void Declarations::DefineMacro(const Macro& macro) {
  if (ReportTakenName(macro.name, macro.name_range, false, nullptr) != NameUse::kFree) return;
  Entity entity;
  entity.kind = Entity::Kind::kMacro;
  entity.name = macro.name;
  entity.range = macro.name_range;
  entity.value = macro.value;
  if (!macro.value.invalid) {
    // A macro whose value does not fit is reported at its definition, not where it is used.
    TypedOperand operand;
    operand.range = macro.name_range;
    operand.literal = macro.value;
    operands_.Adapt(operand,
                    macro.value.kind == Literal::Kind::kFixed ? DataType::kDouble : DataType::kInt);
    entity.value.invalid = operand.literal->invalid;
  }
  context_.globals.Add(entity);
}

bool Declarations::CheckArraySizes(const Declarator& declarator, Entity& entity) {
  int64_t total = 1;
  for (const ExpressionPtr& size : declarator.sizes) {
    Message what = MakeMessage("missing", "空");
    SourceRange range = declarator.name_range;
    if (size != nullptr) {
      what = ToMessage(fmt::format("'{}'", context_.Source(size->range)));
      range = size->range;
      if (size->kind == Expression::Kind::kError) return false;
      if (const std::optional<Literal> constant = context_.ConstantOf(*size)) {
        if (constant->invalid) return false;
        const std::optional<int32_t> value = IntValue(*constant);
        if (value && *value >= 1 && *value <= vm::kSlotCount) {
          entity.dimensions.push_back(*value);
          total *= *value;
          if (total <= vm::kSlotCount) continue;
          what = ToMessage(total);
        }
      } else if (size->kind == Expression::Kind::kName && context_.Lookup(size->text) == nullptr) {
        operands_.ReportUndeclared(*size);
        return false;
      }
    }
    Diagnostic& diagnostic = context_.reporter.Report(Code::kArraySize, range, declarator.name,
                                                      what, int64_t{vm::kSlotCount});
    const std::optional<Constant> value = size != nullptr ? context_.FoldHere(*size) : std::nullopt;
    if (value && !value->is_double && !context_.ConstantOf(*size) && value->integer >= 1 &&
        value->integer <= vm::kSlotCount) {
      Replace(diagnostic, range, value->Text());
    }
    if (size == nullptr && declarator.initialiser != nullptr &&
        declarator.initialiser->kind == Expression::Kind::kBraces && declarator.sizes.size() == 1) {
      SourceRange bracket = declarator.head;
      bracket.begin = bracket.end - 1;
      InsertBefore(diagnostic, bracket, std::to_string(declarator.initialiser->operands.size()));
    }
    return false;
  }
  if (declarator.sizes.size() > 1) {
    std::string product;
    for (const int64_t dimension : entity.dimensions) {
      if (!product.empty()) product += " * ";
      product += std::to_string(dimension);
    }
    SourceRange sizes = declarator.head;
    sizes.begin = declarator.name_range.end;
    Diagnostic& diagnostic =
        context_.reporter.Report(Code::kMultiDimensional, sizes, declarator.name, product);
    Replace(diagnostic, sizes, fmt::format("[{}]", total));
    context_.flat_arrays[declarator.name] = {&diagnostic, true};
  } else {
    context_.flat_arrays.erase(declarator.name);
  }
  entity.array_size = static_cast<uint16_t>(total);
  return true;
}

bool Declarations::ReserveSlots(const Declarator& declarator, Entity& entity) {
  const int64_t needed = entity.structure != nullptr
                             ? static_cast<int64_t>(entity.structure->members.size())
                             : std::max<int64_t>(1, entity.array_size);
  const bool local = context_.function != nullptr;
  uint16_t& used = local ? context_.function->slots : global_slots_;
  bool& reported = local ? context_.function->too_many_slots : too_many_globals_;
  if (used + needed > vm::kSlotCount) {
    // One report is enough: all that follow would exceed the limit too.
    if (!reported) {
      context_.reporter.Report(local ? Code::kTooManyLocals : Code::kTooManyGlobals,
                               declarator.name_range, declarator.name, needed,
                               int64_t{vm::kSlotCount - used}, int64_t{vm::kSlotCount});
    }
    reported = true;
    return false;
  }
  entity.id = used;
  used = static_cast<uint16_t>(used + needed);
  return true;
}

void Declarations::AddSymbols(const Entity& entity) {
  std::vector<vm::Symbol>& symbols =
      context_.function != nullptr ? context_.function->out.variables : context_.object.globals;
  if (entity.structure == nullptr) {
    symbols.push_back({std::string(entity.name), entity.id, entity.type, entity.array_size});
    return;
  }
  uint16_t id = entity.id;
  for (const gtcalls::Member& member : entity.structure->members) {
    symbols.push_back({fmt::format("{}.{}", entity.name, member.name), id++,
                       gtcalls::ProgramType(member.type), 0});
  }
}

Entity* Declarations::Declare(const Declarator& declarator, const DeclaredType& type,
                              bool parameter) {
  const bool local = context_.function != nullptr;
  Entity entity;
  entity.name = declarator.name;
  entity.range = declarator.name_range;
  entity.storage = local ? vm::Storage::kLocal : vm::Storage::kGlobal;
  entity.type = type.type;
  entity.structure = type.structure;
  entity.invalid = !type.valid;
  entity.is_const = type.is_const;
  entity.words = type.words;
  entity.late = local && context_.function->statements_begun;
  Scope& scope = local ? context_.function->locals : context_.globals;
  const NameUse use = ReportTakenName(declarator.name, declarator.name_range, local,
                                      parameter ? nullptr : &declarator);
  if (use == NameUse::kTaken && scope.Find(declarator.name) != nullptr) return nullptr;
  entity.hides = use == NameUse::kHidesAnother;
  if (declarator.pointer) {
    context_.reporter.Report(Code::kPointer, declarator.name_range, declarator.name);
    entity.invalid = true;
  }
  if (!declarator.sizes.empty() && !parameter) {
    if (!CheckArraySizes(declarator, entity)) entity.invalid = true;
    if (entity.structure != nullptr) {
      SourceRange sizes = declarator.head;
      sizes.begin = declarator.name_range.end;
      Replace(context_.reporter.Report(Code::kArraySize, sizes, declarator.name,
                                       MakeMessage("given, but there are no arrays of structures",
                                                   "多余的（不支持结构数组）"),
                                       int64_t{vm::kSlotCount}),
              sizes, "");
      entity.invalid = true;
    }
  }
  if (!entity.invalid && !ReserveSlots(declarator, entity)) entity.invalid = true;
  if (!entity.invalid) AddSymbols(entity);
  if (local) OpenName(declarator.name);
  return &scope.Add(std::move(entity));
}

void Declarations::CheckDeclaration(const Statement& statement, const Place& place) {
  if (context_.function != nullptr && context_.function->statements_begun) {
    CheckLateDeclaration(statement, place);
    return;
  }
  DeclaredType type = ResolveType(statement.specifiers);
  if (type.is_void) {
    context_.reporter.Report(Code::kNotAType, statement.specifiers.range,
                             std::string_view("'void'"), std::string_view("int, double"));
    type.valid = false;
  }
  const bool as_macros =
      CorrectType(statement.specifiers, type, statement.declarators, statement.range);
  for (const Declarator& declarator : statement.declarators) {
    const Entity* entity = Declare(declarator, type, false);
    if (declarator.initialiser == nullptr || as_macros) continue;
    CheckInitialiser(declarator, entity, type);
  }
}

void Declarations::CheckInitialiser(const Declarator& declarator, const Entity* entity,
                                    const DeclaredType& type) {
  SourceRange value = declarator.range;
  value.begin = declarator.head.end;
  const bool usable = entity != nullptr && !entity->invalid;
  context_.statement.failed = false;
  context_.statement.lesson.reset();
  if (declarator.initialiser->kind == Expression::Kind::kBraces) {
    for (const ExpressionPtr& element : declarator.initialiser->operands) {
      operands_.CheckNames(*element);
    }
  } else {
    operands_.CheckNames(*declarator.initialiser);
  }
  const bool failed = context_.statement.failed;
  Diagnostic& diagnostic = context_.reporter.Report(Code::kInitialiser, value, declarator.name);
  if (context_.function == nullptr) {
    if (usable && !failed) CorrectGlobalInitialiser(declarator, diagnostic, value);
    return;
  }
  FunctionState::InitialValues& values = context_.function->initial_values;
  // The type's own errors are corrected first.
  if (!usable || failed || entity->hides || type.is_static || type.is_const) values.good = false;
  if (values.bearer == nullptr) values.bearer = &diagnostic;
  values.list.push_back(&declarator);
}

// One fix-it moves all initial values of a function to its first statement, because each may depend
// on the previous ones.
void Declarations::CorrectInitialValues() {
  const FunctionState::InitialValues& values = context_.function->initial_values;
  if (values.bearer == nullptr || !values.good) return;
  Rewriter rewriter(context_, *values.bearer);
  if (!rewriter.InitialiseFirst(values.list)) return;
  for (const Declarator* declarator : values.list) {
    SourceRange value = declarator->range;
    value.begin = declarator->head.end;
    Replace(*values.bearer, value, "");
  }
  rewriter.Finish();
}

void Declarations::OpenName(std::string_view name) {
  const size_t block = context_.function->blocks.size() - 1;
  const auto [open, added] = context_.function->open_names.emplace(name, block);
  if (!added && open->second == block) return;
  context_.function->blocks.back().names.push_back(
      {name, added ? std::nullopt : std::optional<size_t>(open->second)});
  open->second = block;
}

// Loops often declare the same counter again: one declaration at the top is enough for all of them,
// unless they are nested.
const Entity* Declarations::Reopen(const Declarator& declarator, const DeclaredType& type) {
  const Entity* known = context_.function->locals.Find(declarator.name);
  const bool again = known != nullptr && !context_.function->open_names.contains(declarator.name) &&
                     !known->invalid && !known->hides && known->structure == nullptr &&
                     known->array_size == 0 && declarator.sizes.empty() &&
                     known->words == type.words && type.structure == nullptr && !type.is_const;
  if (!again) return nullptr;
  OpenName(declarator.name);
  return known;
}

void Declarations::CheckLateDeclaration(const Statement& statement, const Place& place) {
  const DeclaredType type = ResolveType(statement.specifiers);
  CorrectType(statement.specifiers, type, statement.declarators, statement.range);
  bool all_good = type.valid && !type.is_void && !type.is_static;
  std::vector<const Declarator*> initialised;
  std::vector<std::string> declarations;
  for (const Declarator& declarator : statement.declarators) {
    const Entity* known = Reopen(declarator, type);
    const Entity* entity = known != nullptr ? known : Declare(declarator, type, false);
    if (entity != nullptr && !entity->invalid && entity->late) {
      declarations.push_back(fmt::format("{} {};", type.words, context_.Source(declarator.head)));
    }
    if (entity == nullptr || entity->invalid || entity->hides) all_good = false;
  }
  context_.statement.failed = false;
  for (const Declarator& declarator : statement.declarators) {
    if (declarator.initialiser == nullptr) continue;
    initialised.push_back(&declarator);
    if (declarator.initialiser->kind == Expression::Kind::kBraces) {
      for (const ExpressionPtr& element : declarator.initialiser->operands) {
        operands_.CheckNames(*element);
      }
    } else {
      operands_.CheckNames(*declarator.initialiser);
    }
  }
  context_.statement.lesson.reset();
  if (context_.statement.failed) all_good = false;
  Diagnostic& diagnostic = context_.reporter.Report(Code::kLateDeclaration, statement.range,
                                                    statement.declarators[0].name);
  if (!all_good) return;
  Rewriter rewriter(context_, diagnostic);
  for (std::string& declaration : declarations) rewriter.AddDeclaration(std::move(declaration));
  rewriter.ReplaceDeclaration(statement, initialised, place);
}

void Declarations::CheckParameters(const Function& syntax) {
  const std::vector<ParameterDeclaration>& parameters = syntax.parameters;
  // `f(void)` has no parameters.
  if (parameters.size() == 1 && parameters[0].declarator.name.empty() &&
      parameters[0].specifiers.words.size() == 1 &&
      parameters[0].specifiers.words[0]->text == "void" && !parameters[0].declarator.pointer) {
    return;
  }
  if (parameters.size() > vm::kParameterMax) {
    context_.reporter.Report(Code::kTooManyParameters, parameters[vm::kParameterMax].range,
                             MakeMessage("the function '{0}'", "函数 '{0}'", syntax.name),
                             int64_t{vm::kParameterMax}, static_cast<int64_t>(parameters.size()));
  }
  for (const ParameterDeclaration& parameter : parameters) {
    DeclaredType type;
    if (parameter.specifiers.words.empty()) {
      Diagnostic& diagnostic =
          context_.reporter.Report(Code::kNotAType, parameter.range,
                                   ToMessage(fmt::format("'{}'", parameter.declarator.name)),
                                   std::string_view("int, double, long, short"));
      InsertBefore(diagnostic, parameter.range, "int ");
    } else {
      type = ResolveType(parameter.specifiers);
      type.is_parameter = true;
      CorrectType(parameter.specifiers, type, {&parameter.declarator, 1}, parameter.range);
    }
    if (type.is_void || type.structure != nullptr) {
      context_.reporter.Report(Code::kBadParameter, parameter.range,
                               ToMessage(fmt::format("'{}'", context_.Source(parameter.range))));
      type.valid = false;
    } else if (parameter.declarator.name.empty()) {
      if (type.valid) {
        SourceRange end = parameter.range;
        end.begin = end.end;
        context_.reporter.Report(Code::kExpectedName, end,
                                 MakeMessage("a parameter without a name", "没有名称的参数"));
      }
      continue;
    }
    if (!parameter.declarator.sizes.empty()) {
      context_.reporter.Report(
          Code::kBadParameter, parameter.range,
          MakeMessage("the array '{0}'", "数组 '{0}'", parameter.declarator.name));
      type.valid = false;
    }
    if (!parameter.declarator.name.empty()) Declare(parameter.declarator, type, true);
  }
}

}  // namespace oncard::compiler
