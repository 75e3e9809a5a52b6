#include "compiler/checker.h"

#include "vm/limits.h"

namespace oncard::compiler {

void Checker::AddSkippedNames(const std::unordered_set<std::string_view>& names) {
  context_.skipped_names.insert(names.begin(), names.end());
}

vm::Object Checker::Check(const Tree& tree) {
  context_.tree = &tree;
  for (const StatementPtr& item : tree.items) {
    if (item->kind == Statement::Kind::kFunction) {
      context_.function_names.emplace(item->function->name, item->function->name_range);
    }
  }
  for (const StatementPtr& item : tree.items) CheckItem(*item);
  return std::move(context_.object);
}

void Checker::CheckFunction(const Function& syntax) {
  FunctionState* const outer = context_.function;
  context_.function = nullptr;
  const Declarations::DeclaredType type = declarations_.ResolveType(syntax.specifiers);
  if (declarations_.KeepsReturns(syntax, type)) {
    declarations_.CorrectType(syntax.specifiers, type, {}, syntax.header);
  }
  if (type.structure != nullptr || syntax.pointer) {
    context_.reporter.Report(
        Code::kNotAType, syntax.specifiers.range,
        ToMessage(fmt::format("'{}{}'", context_.Source(syntax.specifiers.range),
                              syntax.pointer ? "*" : "")),
        std::string_view("int, double, void"));
  }
  if (syntax.prototype) {
    SourceRange semicolon = syntax.close_brace;
    AddNote(context_.reporter.Report(Code::kMissingOpenBrace, semicolon, std::string_view("';'")),
            MakeMessage("functions are not called, so they need no declaration",
                        "函数不会被调用，因此不需要提前声明"));
    context_.function = outer;
    return;
  }
  if (declarations_.ReportTakenName(syntax.name, syntax.name_range, false, nullptr) ==
      Declarations::NameUse::kFree) {
    Entity entity;
    entity.kind = Entity::Kind::kFunction;
    entity.name = syntax.name;
    entity.range = syntax.name_range;
    context_.globals.Add(entity);
  }
  ++function_count_;
  if (function_count_ == vm::kFunctionMax + 1) {
    context_.reporter.Report(Code::kTooManyFunctions, syntax.name_range, syntax.name,
                             int64_t{vm::kFunctionMax});
  }

  FunctionState state;
  state.syntax = &syntax;
  state.is_void = type.is_void;
  state.out.name = syntax.name;
  state.out.file = context_.files[static_cast<size_t>(syntax.header.file)].IniName();
  state.out.return_type = type.is_void ? vm::DataType::kVoid : type.type;
  state.declarations_end = syntax.open_brace;
  state.declarations_end.begin = syntax.open_brace.end;
  state.statements_begin = syntax.close_brace;
  for (const StatementPtr& item : syntax.body) {
    if (item->kind != Statement::Kind::kDeclaration && item->kind != Statement::Kind::kMacro) {
      state.statements_begin = item->range;
      break;
    }
  }
  for (const StatementPtr& item : syntax.body) {
    ForEachStatement(*item, [&state](const Statement& below) {
      if (below.kind == Statement::Kind::kGoto) {
        state.gotos.push_back({below.name, below.name_range});
      }
      for (const Declarator& declarator : below.declarators) ++state.declarations[declarator.name];
    });
  }
  for (const ParameterDeclaration& parameter : syntax.parameters) {
    ++state.declarations[parameter.declarator.name];
  }
  context_.function = &state;
  OpenBlock(nullptr);
  declarations_.CheckParameters(syntax);
  state.places.parameter_slots = state.slots;
  state.places.body = {syntax.open_brace.file, syntax.open_brace.begin, syntax.close_brace.end};
  // The temporaries of rewritten statements are declared after the last declaration.
  for (const StatementPtr& item : syntax.body) {
    if (item->kind == Statement::Kind::kMacro) continue;
    if (item->kind != Statement::Kind::kDeclaration) break;
    state.declarations_end = item->range;
    state.declarations_end.begin = item->range.end;
  }
  Place place;
  place.followed = false;
  CheckBody(syntax.body, place);
  declarations_.CorrectInitialValues();
  ResolveJumps();
  context_.function = outer;
  context_.object.functions.push_back(std::move(state.out));
  context_.places.push_back(std::move(state.places));
}

}  // namespace oncard::compiler
