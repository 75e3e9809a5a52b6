// The functions of a program: which of them are thread functions.
#include <fmt/core.h>

#include <algorithm>

#include "compiler/lowering/lowerer.h"
#include "compiler/tree_walk.h"

namespace oncard::compiler::lowering {
namespace {

// Words that a generated name must not have.
constexpr std::string_view kReserved[] = {
    "int",      "long",   "short",   "void",     "double", "if",   "goto",    "return",
    "else",     "while",  "for",     "do",       "switch", "case", "default", "break",
    "continue", "struct", "typedef", "unsigned", "signed", "char", "float",   "static",
    "const",    "sizeof", "enum",    "union",    "extern", "abs",  "fabs"};

}  // namespace

void Lowerer::DeclareFunction(const Function& syntax) {
  Symbol symbol;
  symbol.kind = Symbol::Kind::kFunction;
  symbol.range = syntax.name_range;
  symbol.order = order_;
  global_names_.Reserve(syntax.name);
  const auto found = scopes_[0].find(syntax.name);
  if (found != scopes_[0].end()) {
    FunctionInfo* known = found->second.function;
    if (known == nullptr || (!syntax.prototype && !known->syntax->prototype)) {
      Report(Code::kRedefinition, syntax.name_range, syntax.name);
      return;
    }
    if (!syntax.prototype) {
      known->syntax = &syntax;
      known->order = order_;
    }
    if (HasWord(syntax.specifiers, "static")) known->is_static = true;
    return;
  }
  FunctionInfo& info = functions_.emplace_back();
  info.syntax = &syntax;
  info.order = order_;
  info.type = ResolveGlobalType(syntax.specifiers);
  if (info.type.rows != nullptr) {
    Report(Code::kNotLowered, syntax.specifiers.range,
           MakeMessage("a function whose result is an array", "返回数组的函数"),
           MakeMessage("write the result to an array parameter", "请把结果写入数组参数"));
  }
  info.is_static = HasWord(syntax.specifiers, "static");
  symbol.type = info.type;
  symbol.function = &info;
  scopes_[0].emplace(syntax.name, std::move(symbol));
}

// Who calls whom. A name that a local hides counts as a call too; it is reported where it is used.
void Lowerer::CollectCalls(FunctionInfo& info) {
  const auto in_expression = [this, &info](const Expression& expression) {
    if (expression.kind != Expression::Kind::kCall) return;
    const Expression& callee = WithoutParens(*expression.operands[0]);
    if (callee.kind != Expression::Kind::kName) return;
    const auto found = scopes_[0].find(callee.text);
    if (found == scopes_[0].end() || found->second.function == nullptr) return;
    if (info.tail_calls.contains(&expression)) return;
    found->second.function->called = true;
    info.calls.emplace_back(found->second.function, &expression);
  };
  const auto in_statement = [&in_expression](const Statement& statement) {
    ForEachWholeExpression(statement, [&in_expression](const Expression& whole) {
      ForEachExpression(whole, in_expression);
    });
  };
  for (const StatementPtr& item : info.syntax->body) ForEachStatement(*item, in_statement);
}

void Lowerer::DefineLabels(Frame& frame) {
  for (const StatementPtr& item : frame.info->syntax->body) {
    ForEachStatement(*item, [this, &frame](const Statement& statement) {
      if (statement.kind != Statement::Kind::kLabel) return;
      if (frame.labels.contains(statement.name)) {
        Report(Code::kRedefinition, statement.name_range, statement.name);
        return;
      }
      frame.labels.emplace(statement.name, NewLabel(frame.prefix + std::string(statement.name)));
    });
  }
}

// The statements of a thread function. Those of a function that is too long are not complete.
LoweredFunction Lowerer::LowerFunction(FunctionInfo& info) {
  const Function& syntax = *info.syntax;
  LoweredFunction function;
  out_ = &function;
  names_ = NameMaker(&global_names_);
  written_names_.clear();
  label_names_ = NameMaker();
  variables_.clear();
  bodies_.clear();
  frames_.clear();
  recursive_calls_.clear();
  blocks_.clear();
  inlined_ = 0;
  instance_ = -1;
  stopped_ = false;
  function.name = syntax.name;
  function.type = DataTypeOf(info.type.basic);
  function.header = syntax.header;
  function.end = syntax.close_brace;

  if (info.type.own != nullptr) {
    Report(Code::kNotLowered, syntax.specifiers.range,
           MakeMessage("a thread function whose result is a structure", "返回结构的线程函数"),
           MakeMessage("write the result to a global structure", "请把结果写入全局结构"));
    function.end = syntax.close_brace;
    out_ = nullptr;
    return function;
  }
  Frame frame;
  frame.info = &info;
  frame.scope_base = scopes_.size();
  frame_ = &frame;
  OpenBlock(&syntax);
  BeginFullExpression(syntax.header);
  for (const ParameterDeclaration& parameter : syntax.parameters) {
    const Type type = ResolveGlobalType(parameter.specifiers);
    const Declarator& declarator = parameter.declarator;
    if (type.basic == BasicType::kVoid) continue;
    if (IsReference(declarator, type) || type.basic == BasicType::kStructure) {
      Report(Code::kThreadParameter, parameter.range, declarator.name, syntax.name);
      Symbol unusable;
      unusable.range = declarator.name_range;
      unusable.invalid = true;
      Define(declarator.name, std::move(unusable));
      continue;
    }
    Symbol symbol;
    symbol.type = type;
    symbol.range = declarator.name_range;
    symbol.variable =
        NewVariable(Variable::Role::kParameter, declarator.name, type, {}, declarator.name_range);
    function.parameters.push_back(symbol.variable);
    Define(declarator.name, std::move(symbol));
  }
  DefineLabels(frame);
  BeginBody();
  LowerBody(syntax.body);
  EmitFrames();
  EmitWaysBack();
  CloseBlock();
  frame_ = nullptr;
  out_ = nullptr;
  return function;
}

// The names of globals, so that the members of structures get others.
void Lowerer::ReserveGlobals(const Tree& tree) {
  for (const StatementPtr& item : tree.items) {
    if (item->kind == Statement::Kind::kFunction) global_names_.Reserve(item->function->name);
    for (const Declarator& declarator : item->declarators) global_names_.Reserve(declarator.name);
  }
}

Program Lowerer::Lower(const Tree& tree, const std::vector<AssertComment>& asserts,
                       const std::vector<DepthComment>& depths) {
  scopes_.emplace_back();
  for (const std::string_view word : kReserved) global_names_.Reserve(word);
  for (const gtcalls::Structure& structure : options_.catalogue->structures()) {
    if (structure.in_motion_program) CardStructure(structure);
  }
  ReserveGlobals(tree);
  for (const StatementPtr& item : tree.items) {
    ++order_;
    switch (item->kind) {
      case Statement::Kind::kFunction:
        DeclareFunction(*item->function);
        for (const auto& other : item->function->others) DeclareFunction(*other);
        break;
      case Statement::Kind::kDeclaration:
        LowerDeclaration(*item);
        break;
      default:
        break;
    }
  }
  PlaceAsserts(tree, asserts);
  for (FunctionInfo& info : functions_) {
    FindTailCalls(info);
    CollectCalls(info);
  }
  FindGroups();
  const size_t reported = reporter_.diagnostics().size();
  PlaceDepths(tree, depths);
  SetDepths();
  ProveDepths();
  // Which functions lack a depth is not known then.
  if (reporter_.diagnostics().size() > reported) return std::move(program_);
  bool unbounded = false;
  for (FunctionInfo& info : functions_) {
    std::vector<FunctionInfo*> path;
    if (info.mark == 0 && !info.is_static) unbounded |= RecursesUnbounded(info, path);
  }
  if (unbounded) return std::move(program_);
  for (FunctionInfo& info : functions_) {
    if (!info.called && !info.is_static && !info.syntax->prototype) LowerThreadFunction(info);
  }
  program_.start_statements = static_cast<int>(program_.statements.size());
  MoveTables();
  for (LoweredFunction& function : program_.functions) EmitStart(function);
  return std::move(program_);
}

}  // namespace oncard::compiler::lowering
