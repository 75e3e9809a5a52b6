// Translates the tree of a structured program to the statements of the card, construct by
// construct: program.cc has the functions and the order of work, declarations.cc and
// initialisers.cc variables, structures.cc those of structures, statements.cc, loops.cc and
// switches.cc statements, expressions.cc, unsigned.cc, conversions.cc, conditions.cc,
// assignments.cc and places.cc expressions, calls.cc own functions, asserts.cc comments,
// shared_bodies.cc those whose statements stand once for several calls, recursion.cc which call
// themselves, frames.cc what these keep, tail_calls.cc calls that become loops, commands.cc GT
// commands, tables.cc constants of a page, start.cc initial values of globals.
//
// Rules that all of them keep:
// - An operand is read in the statement that uses it, so a global is read exactly as often as in C.
//   Values that are used twice are loaded into a temporary first.
// - Every temporary is new. The last pass lets them share slots.
// - A mistake is reported once, and an operand of value 0 takes its place.
//
// What is virtual is different for single statements of a program of the card (fragment.cc), whose
// types are those of the card, and whose bodies stay as they are.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "compiler/asserts.h"
#include "compiler/compiler.h"
#include "compiler/constant_folding.h"
#include "compiler/depth_comments.h"
#include "compiler/lowering/ir.h"
#include "compiler/lowering/lowering.h"
#include "compiler/lowering/types.h"
#include "compiler/macro_expander.h"
#include "compiler/reporter.h"
#include "compiler/syntax.h"

namespace oncard::compiler::lowering {

/// A number that is known while compiling; unsigned ones have the bits of an int.
struct TypedConstant {
  BasicType type = BasicType::kInt;
  Constant value;
};

/// The value of an expression.
struct Value {
  Operand operand;  ///< kNone: void, or a structure, or an error
  BasicType type = BasicType::kInt;
  /// A type, perhaps a narrower one, to which every possible value belongs: bool for `a < b`.
  BasicType range = BasicType::kInt;
};

/// Something that can be assigned.
struct Place {
  Operand operand;
  Type type;
};

/// The type of what an expression names.
struct Shape {
  Type type;                        ///< of an element
  std::vector<int64_t> dimensions;  ///< as those of an ArrayPlace
  bool is_pointer = false;          ///< to the array: a parameter, `&x`, `a + 1`
  bool invalid = false;             ///< there was an error
};

/// An array, a row of one, or an array parameter.
struct ArrayPlace {
  int variable = -1;
  Operand offset;                   ///< of its first element: a constant or an int variable
  std::vector<int64_t> dimensions;  ///< the first is 0 if unknown, as in `int a[]`
  Type element;
  std::string_view name;
};

/// Makes names that are at most 31 characters long and different from each other.
class NameMaker {
 public:
  NameMaker() = default;
  /// The names are also different from those that `base` has now. It must outlive the maker; what
  /// it makes later does not count.
  explicit NameMaker(const NameMaker* base) : base_(base), base_count_(base->used_.size()) {}

  void Reserve(std::string_view name) { used_.try_emplace(std::string(name), used_.size()); }
  std::string Make(std::string_view wish);

 private:
  /// False if the name is used already.
  bool Take(const std::string& name);

  const NameMaker* base_ = nullptr;
  size_t base_count_ = 0;
  std::unordered_map<std::string, size_t> used_;  // with the number of names before each
  std::unordered_map<std::string, int> next_;
};

class Lowerer {
 public:
  /// The files, the tree and the uses of macros must outlive the lowerer. When optimising, calls
  /// are jumps where that makes a thread function shorter; otherwise all are inlined.
  Lowerer(const Options& options, const std::deque<SourceFile>& files, const MacroUses& macros,
          Reporter& reporter, const LoweringOptions& lowering_options)
      : options_(options),
        files_(files),
        macros_(macros),
        reporter_(reporter),
        lowering_options_(lowering_options) {}

  virtual ~Lowerer() = default;
  Lowerer(const Lowerer&) = delete;
  Lowerer& operator=(const Lowerer&) = delete;

  /// Translates a whole program with its asserts and the depths of its recursion. The result is
  /// valid only if no error was reported.
  Program Lower(const Tree& tree, const std::vector<AssertComment>& asserts,
                const std::vector<DepthComment>& depths);

 protected:
  struct FunctionInfo {
    const Function* syntax = nullptr;
    Type type;
    int order = 0;
    bool is_static = false;
    bool called = false;
    std::vector<std::pair<FunctionInfo*, const Expression*>> calls;
    std::unordered_set<const Expression*> tail_calls;  // of itself, which become jumps
    int mark = 0;                                      // while looking for recursion
    int height = 0;                                    // levels of calls below it
    int group = 0;  // the functions that call each other to which it belongs; 0: none
    const DepthComment* depth = nullptr;  // right above it
    // In the thread function that is being translated:
    bool shared = false;  // its calls are jumps
    int copies = 0;       // how often it is inlined
    size_t copied = 0;    // statements of the longest copy
    size_t as_jumps = 0;  // what its bodies and their calls take
    size_t as_copies = 0;
  };
  struct Symbol {
    enum class Kind : uint8_t { kVariable, kConstant, kFunction, kType };
    Kind kind = Kind::kVariable;
    Type type;
    SourceRange range;
    int order = 0;  // of a global: position in the program
    bool invalid = false;
    bool is_extern = false;     // a global that is declared and not defined so far
    bool initialised = false;   // a global
    bool moves = false;         // the function moves it: its offset is a variable
    bool is_reference = false;  // a parameter that stands for a number or an array of the caller
    int variable = -1;
    std::vector<int64_t> dimensions;
    Operand offset;
    TypedConstant constant;
    FunctionInfo* function = nullptr;
  };
  using Scope = std::unordered_map<std::string_view, Symbol>;
  // Where `break` and `continue` lead; -1: nowhere.
  struct Targets {
    int break_label = -1;
    int continue_label = -1;
  };
  // A function of C that is being translated: a thread function, or one that is inlined.
  struct Frame {
    const FunctionInfo* info = nullptr;
    size_t scope_base = 0;
    std::string prefix;    // of names: empty, or the inlined function's
    int begin_label = -1;  // of a function that calls itself in its end
    int return_label = -1;
    Operand result;  // of an inlined function
    std::unordered_map<std::string_view, int> labels;
    std::vector<Targets> targets;
    std::vector<std::unordered_map<const Statement*, int>> cases;
    int body = 0;   // the shared body that it belongs to; 0: none
    int group = 0;  // the recursive functions that it belongs to, or is inlined in; 0: none
  };
  // Functions that call themselves through each other, or one that calls itself.
  struct Group {
    std::vector<FunctionInfo*> members;  // in their order
    int depth = 0;                       // frames at the same time; 0: not known
  };
  class DepthProof;
  // A call of a group within the group, in the thread function that is being translated.
  struct RecursiveCall {
    int group = 0;
    int body = 0;             // the one that calls
    size_t save = 0;          // the statement that keeps the first thing
    size_t jump = 0;          // the statement before the other body
    size_t restore = 0;       // the first statement behind it
    std::vector<int> kept;    // variables that it needs afterwards
    std::vector<int> arrays;  // where they are meanwhile
  };
  struct VariableRange {
    int begin = 0;
    int end = 0;
  };
  // The variables of a group in the thread function that is being translated.
  struct Frames {
    Operand depth;     // how many frames are kept
    int back = -1;     // an array: which call each of them was
    size_t rows = 0;   // of the arrays
    size_t slots = 0;  // of a frame
    SourceRange range;
  };
  // The statements of a function that stand once for several calls.
  struct SharedBody {
    FunctionInfo* function = nullptr;
    Scope scope;  // its parameters
    int id = 0;   // from 1
    int begin = -1;
    int end = -1;
    Operand number;  // of the call
    Operand result;
    int instance = -1;      // around its statements
    std::vector<int> back;  // where the calls go on, by number
  };
  // What a call gives a parameter.
  struct Argument {
    Place place;
    Value value;
    SourceRange range;
    std::optional<ArrayPlace> structure;  // that of a parameter that is one
  };
  // A structure of the card in an array, and the variable in which a command gets it.
  struct Passed {
    ArrayPlace element;
    ArrayPlace variable;
  };
  // Where the statements of a called function leave their result and lead.
  struct BodyEnd {
    int body = 0;
    int label = -1;
    Operand result;
  };
  // What a thread function takes with some calls as jumps.
  struct Size {
    bool stopped = false;
    int labels = 0;  // or the limit, if they are fewer
    int statements = 0;
    size_t translated = 0;  // statements, before the passes
  };
  // A value that a global has before the first thread starts.
  struct InitialValue {
    Operand target;
    Operand value;
    SourceRange range;
  };
  // A row of an array or a member of a structure, and which of its values is the first one.
  struct Part {
    Shape shape;
    int64_t begin = 0;
  };
  // The places that a designator names among the rows, elements or members of its level.
  struct Designation {
    int64_t first = 0;
    int64_t last = 0;
  };
  // A value of an aggregate's initialiser.
  struct Element {
    const Expression* value = nullptr;  // nullptr: 0
    // It is one of those that a structure of the program gives, which is the value of the first.
    bool of_structure = false;
  };
  using Elements = std::vector<Element>;
  struct Filling {
    std::string_view name;  // of the variable
    Elements elements;
  };

  // --- program.cc ---
  void ReserveGlobals(const Tree& tree);
  void DeclareFunction(const Function& syntax);
  void CollectCalls(FunctionInfo& info);
  LoweredFunction LowerFunction(FunctionInfo& info);
  void DefineLabels(Frame& frame);

  // --- declarations.cc ---
  Type ResolveType(const Specifiers& specifiers) const;
  Type ResolveGlobalType(const Specifiers& specifiers) const;
  Type TypeFrom(const Specifiers& specifiers, const Scope* scope) const;
  void DefineType(const Declarator& declarator, const Type& type);
  bool HasWord(const Specifiers& specifiers, std::string_view word) const;
  void DefineTypesOf(const Specifiers& specifiers);
  virtual void LowerDeclaration(const Statement& statement);
  void DefineEnumeration(const Enumeration& enumeration);
  void CheckNameLength(std::string_view name, SourceRange range);
  static bool Redeclares(const Symbol& first, const Symbol& symbol);
  void DeclareGlobal(const Declarator& declarator, const Type& type, bool is_extern);
  void DeclareExtern(const Declarator& declarator);
  bool IsUsable(const Symbol& symbol, std::string_view name);
  void DeclareLocal(const Declarator& declarator, const Type& type, bool is_static);
  bool DeclareConstant(const Declarator& declarator, const Type& type);
  static bool IsReference(const Declarator& parameter, const Type& type);
  std::optional<std::vector<int64_t>> Dimensions(const Declarator& declarator, const Type& type);
  void SetDimensions(const Declarator& declarator, bool is_extern, Symbol& symbol);
  void Define(std::string_view name, Symbol symbol);
  const Symbol* Lookup(std::string_view name) const;
  std::string NewWrittenName(std::string_view wish);
  int NewVariable(Variable::Role role, std::string_view wish, const Type& type,
                  const std::vector<int64_t>& dimensions, SourceRange range);
  int VariableOf(const void* declaration, Variable::Role role, std::string_view name,
                 const Type& type, const std::vector<int64_t>& dimensions, SourceRange range);
  std::string NewGlobalName(std::string_view wish);
  int NewGlobal(const std::string& name, const Type& type, const std::vector<int64_t>& dimensions,
                SourceRange range);

  // --- structures.cc ---
  const OwnStructure* CardStructure(const gtcalls::Structure& card);
  const OwnStructure* FindStructure(const StructSpecifier& syntax, const Scope* scope) const;
  bool IsComplete(const Type& type, std::string_view name, SourceRange range);
  void DefineStructure(const StructSpecifier& syntax);
  void AddMember(OwnStructure& structure, const Declarator& declarator, const Type& type);
  static const OwnMember* MemberOf(const OwnStructure& structure, std::string_view name);
  void ReportNoMember(const OwnStructure& structure, std::string_view name, SourceRange range);
  void Narrow(ArrayPlace& place, const OwnMember& member, SourceRange range);
  std::optional<ArrayPlace> LowerOwnMember(const Expression& expression);
  static ArrayPlace StructureAt(int variable, const Type& type);
  static int LeavesOf(const Type& type);
  std::optional<ArrayPlace> LowerStructure(const Expression& expression);
  std::optional<ArrayPlace> AssignStructure(const Expression& target, const Expression& value);
  void StoreStructure(const ArrayPlace& to, const Expression& value);
  void CopyStructure(const ArrayPlace& to, const ArrayPlace& from, SourceRange range);
  void CopyLeaf(ArrayPlace to, ArrayPlace from, SourceRange range);
  void StepTo(const Operand& index, int64_t size, int loop, SourceRange range);

  // --- initialisers.cc ---
  void InitialiseGlobal(const Declarator& declarator, const Symbol& symbol);
  void InitialiseLocal(const Declarator& declarator, const Symbol& symbol);
  void Initialise(const Expression& initialiser, std::string_view name, SourceRange range,
                  const Symbol& symbol);
  std::optional<ArrayPlace> LowerCompoundLiteral(const Expression& literal);
  const Expression* ScalarValue(const Expression& value);
  static int64_t Width(const Shape& shape);
  static bool IsAggregate(const Shape& shape);
  Part PartOf(const Shape& whole, int64_t number) const;
  int64_t PartNumberAt(const Shape& whole, int64_t position) const;
  Shape PartAt(const Shape& whole, int64_t position) const;
  Shape PartFor(const Expression& item, Shape part) const;
  bool HasType(const Expression& value, const Shape& shape) const;
  std::optional<Designation> Designate(const Expression& designator, const Shape& whole,
                                       std::string_view name);
  bool Flatten(const Expression& braces, const Shape& whole, int64_t base, Filling& filling);
  bool FlattenItem(const Expression& item, const Shape& part, int64_t position, Filling& filling);
  bool FlattenDesignated(const Expression& item, const Shape& whole, int64_t base, Filling& filling,
                         int64_t* position);
  std::optional<Elements> ElementsOf(const Declarator& declarator, const Symbol& symbol);
  std::optional<Elements> ElementsOf(const Expression& values, std::string_view name,
                                     const Symbol& symbol);
  ArrayPlace PlaceAt(const Symbol& symbol, int64_t position, const OwnStructure* own) const;
  void InitialiseLeaf(int variable, const Type& type, const Elements& values, SourceRange range);
  void ClearElements(int variable, int64_t begin, int64_t end, SourceRange range);
  Operand ElementOperand(int variable, int64_t index) const;

  // --- statements.cc ---
  void LowerBody(const std::vector<StatementPtr>& items);
  void LowerStatement(const Statement& statement);
  /// The body of a branch, a loop or a switch.
  virtual void LowerInner(const Statement& body);
  void LowerIf(const Statement& statement);
  void LowerReturn(const Statement& statement);
  void LowerReturnOf(const Expression* value, const Statement& statement);
  void LowerLeave(const Statement& statement);
  virtual std::optional<int> JumpTarget(const Statement& statement);

  // --- loops.cc ---
  void LowerWhile(const Statement& statement);
  void LowerDo(const Statement& statement);
  void LowerFor(const Statement& statement);

  // --- switches.cc ---
  void LowerSwitch(const Statement& statement);

  // --- asserts.cc ---
  void PlaceAsserts(const Tree& tree, const std::vector<AssertComment>& asserts);
  bool HasAssert(const Statement& statement) const;
  std::optional<ArrayPlace> NamedPlace(const Symbol& symbol, std::string_view* text);
  void EmitAsserts(const Statement& statement);

  // --- expressions.cc ---
  Value LowerValue(const Expression& expression);
  void LowerEffect(const Expression& expression);
  Value LowerUnary(const Expression& expression);
  Value LowerBinary(const Expression& expression);
  Value LowerName(const Expression& expression);
  Value Arithmetic(const vm::OperatorInfo& info, Value a, Value b, const Expression& expression);
  Value Compute(vm::BinaryOperator op, const Operand& a, const Operand& b, BasicType type,
                SourceRange range);
  Value Compute(vm::UnaryOperator op, const Operand& a, BasicType type, SourceRange range);
  bool RequireNumber(const Value& value, const Expression& expression);

  // --- type_of.cc ---
  std::optional<Shape> ShapeOf(const Expression& expression) const;
  BasicType TypeOf(const Expression& expression);
  static int64_t SizeOfType(const Type& type);
  static int64_t AlignmentOf(const Type& type);
  static std::optional<int64_t> MemberNumber(const Type& type, std::string_view name);
  virtual BasicType MemberType(const gtcalls::Member& member) const;
  virtual std::optional<BasicType> CastType(const Expression& expression);
  std::optional<int64_t> SizeOfOperand(const Expression& expression);

  // --- unsigned.cc ---
  Value CompareUnsigned(vm::BinaryOperator op, const Value& a, const Value& b, SourceRange range);
  Value DivideUnsigned(const Value& a, const Value& b, bool remainder, SourceRange range);
  Value ShiftUnsignedRight(const Value& a, const Value& count, SourceRange range);

  // --- constants.cc ---
  virtual std::optional<TypedConstant> Evaluate(const Expression& expression);
  std::optional<TypedConstant> EvaluateBinary(const Expression& expression);
  virtual std::optional<int64_t> EvaluateInteger(const Expression& expression);
  Value ConstantValue(const TypedConstant& constant, const Expression& expression);
  /// Lets a constant be printed as the expression is written.
  virtual void KeepSpelling(const Expression& /*expression*/, Operand& /*constant*/) {}
  static std::optional<TypedConstant> ConvertConstant(const TypedConstant& constant,
                                                      BasicType type);
  std::optional<TypedConstant> LiteralConstant(const Expression& expression) const;

  // --- conversions.cc ---
  Value Convert(Value value, BasicType type, SourceRange range);
  Value Load(Value value, SourceRange range);
  Operand Stable(const Operand& operand, SourceRange range);

  // --- conditions.cc ---
  void BranchIf(const Expression& condition, bool when, int label);
  void BranchOnValue(const Value& value, bool when, int label, SourceRange range);
  Value LowerLogical(const Expression& expression);
  Value LowerConditional(const Expression& expression);

  // --- places.cc ---
  std::optional<Place> LowerPlace(const Expression& expression);
  /// The int that is the value of an index.
  virtual std::optional<Operand> LowerIndex(const Expression& index);
  std::optional<ArrayPlace> LowerArray(const Expression& expression);
  bool IsArray(const Expression& expression) const;
  std::optional<ArrayPlace> LowerNamedArray(const Expression& name);
  std::optional<ArrayPlace> LowerAddressed(const Expression& target);
  std::optional<ArrayPlace> LowerArraySum(const Expression& sum);
  std::optional<ArrayPlace> LowerMove(const Expression& expression, bool value_used);
  Value LowerPlaces(const Expression& expression, const vm::OperatorInfo& info);
  void Advance(ArrayPlace& array, const Operand& count, bool back, SourceRange range);
  std::optional<Operand> ElementOf(const ArrayPlace& array, SourceRange range);
  std::optional<Place> LowerElement(const Expression& expression);
  void ReportStructure(const Expression& expression);
  bool IsOwnMember(const Expression& expression) const;
  void ReportNotAStructure(const Expression& member);
  void ReportUndeclared(const Expression& name);
  bool CheckPlace(const Expression& expression);
  bool CheckWritable(const Place& place, const Expression& expression);

  // --- assignments.cc ---
  virtual Value LowerAssignment(const Expression& expression, bool value_used);
  Value LowerMoved(const Expression& expression, bool value_used);
  Value LowerCompound(const Expression& expression, bool value_used);
  Value LowerStep(const Expression& expression, bool value_used);
  void AssignInto(const Place& place, const Expression& value);
  virtual void AssignBoth(const Place& place, const Expression& conditional);
  Value Store(const Place& place, Value value, SourceRange range, bool value_used);
  Value Update(Place place, const vm::OperatorInfo& info, const Value& change,
               const Expression& expression, bool value_used);

  // --- calls.cc ---
  Value LowerCall(const Expression& expression);
  Operand NewResult(const Expression& call, const FunctionInfo& info);
  Operand LoadedOnce(const Operand& value, SourceRange range);
  ArrayPlace CopyOf(const ArrayPlace& structure, SourceRange range);
  Value LowerOwnCall(const Expression& call, FunctionInfo& info);
  void LowerBodyOf(const Expression& call, FunctionInfo& info, Scope scope, const BodyEnd& end);
  std::optional<Symbol> BindReference(const ParameterDeclaration& parameter, size_t number,
                                      const Expression& argument, const FunctionInfo& info);
  static bool IsMoved(std::string_view name, const Function& function);
  void KeepOffsets(Scope& scope, SourceRange range);
  std::optional<std::vector<const ParameterDeclaration*>> ParametersOf(const Expression& call,
                                                                       const Function& syntax);
  bool BindArguments(const Expression& call, const FunctionInfo& info, Scope& scope);
  void Assign(const std::vector<Argument>& arguments);
  Value LowerMagnitude(const Expression& call, bool real);

  // --- shared_bodies.cc ---
  void LowerThreadFunction(FunctionInfo& info);
  void ChooseShared(FunctionInfo& info);
  Size TrySize(FunctionInfo& info);
  bool CanShare(const FunctionInfo& info, const Scope& scope) const;
  SharedBody* FindBody(const FunctionInfo& info, const Scope& scope);
  Value LowerSharedCall(const Expression& call, FunctionInfo& info, Scope scope);
  void EmitWaysBack();
  void CompareBodies();

  // --- tail_calls.cc ---
  void FindTailCalls(FunctionInfo& info);
  void AddTailCalls(const Expression& value, FunctionInfo& info);
  void AddLast(const Statement& statement, FunctionInfo& info);
  void AddLastOf(const std::vector<StatementPtr>& items, FunctionInfo& info);
  bool EndsHere(const Statement& statement) const;
  bool KeepsReferences(const Expression& call, const FunctionInfo& info) const;
  static bool MovesInTailCall(const FunctionInfo& info, size_t parameter);
  bool IsTailCall(const Expression& expression) const;
  bool HasTailCall(const Expression& value) const;
  void BeginBody();
  void LowerTailCall(const Expression& call);

  // --- recursion.cc ---
  void FindGroups();
  void CloseGroup(FunctionInfo& first, std::vector<FunctionInfo*>& open);
  void PlaceDepths(const Tree& tree, const std::vector<DepthComment>& depths);
  void PlaceDepth(const Tree& tree, const DepthComment& comment);
  void SetDepths();
  bool RecursesUnbounded(FunctionInfo& info, std::vector<FunctionInfo*>& path);
  bool HasCallers(const Group& group) const;
  bool PassesNames(const FunctionInfo& info, size_t parameter) const;

  // --- proved_depth.cc ---
  void ProveDepths();

  // --- frames.cc ---
  Group& GroupOf(const FunctionInfo& info) { return groups_[static_cast<size_t>(info.group) - 1]; }
  bool IsRecursive(const FunctionInfo& info) const;
  Frames& FramesOf(const FunctionInfo& info, SourceRange range);
  void BeginFrame(const FunctionInfo& info, SourceRange range);
  void EndFrame(RecursiveCall& call, SourceRange range);
  Operand BackOf(const Frames& frames) const;
  void ChangeDepth(const Frames& frames, vm::BinaryOperator by_one, SourceRange range);
  void OwnByFrames(int variable, const Type& type, int group);
  void EmitFrames();
  std::vector<std::vector<size_t>> WaysTo() const;
  VariableRange VariablesOf(const Operand& operand) const;
  std::set<int> WrittenBefore(const RecursiveCall& call,
                              const std::vector<std::vector<size_t>>& before) const;
  void FindKept(int group);
  std::string KeptName(int number) const;
  void MakeArrays(int group, const Group& sizes);
  int NewArray(const Frames& frames, std::string_view wish, vm::DataType type, int size);
  void CopyKept(const RecursiveCall& call, bool save);

  // --- commands.cc ---
  void LowerCommand(const Expression& call, const gtcalls::Command& command);
  ArrayPlace PassedThrough(const Type& type, SourceRange range);
  std::optional<Operand> LowerCardAddress(ArrayPlace structure, SourceRange range,
                                          std::vector<Passed>& passed);
  std::optional<Operand> LowerAddress(const Expression& argument, std::vector<Passed>& passed);
  void NameConstant(const Expression& argument, Operand& value);
  bool IsFreeName(std::string_view name) const;

  // --- tables.cc ---
  void MoveTables();
  void MoveTable(int table, LoweredFunction& function);

  // --- start.cc ---
  void EmitStart(LoweredFunction& function);

  // --- Building blocks (builder.cc) ---
  Instruction& Emit(Instruction instruction, SourceRange range);
  void EmitCopy(const Operand& target, const Operand& value, SourceRange range);
  void EmitGoto(int label, SourceRange range);
  void EmitIf(const Operand& condition, int label, SourceRange range);
  void EmitLabel(int label, SourceRange range);
  Operand NewTemporary(vm::DataType type, SourceRange range);
  int NewLabel(std::string_view wish);
  virtual int NewLabel(std::string_view construct, SourceRange keyword, std::string_view part = {});
  bool EndsInJump() const;
  void OpenBlock(const void* block, Scope names = {});
  void CloseBlock();
  void BeginFullExpression(SourceRange range);
  bool IsShared(const Operand& operand) const;
  Operand VariableOperand(int variable) const;
  std::string_view Source(SourceRange range) const;
  int LineOf(SourceRange range) const;

  /// Reports unless the same was reported at the same place, in another copy of an inlined
  /// function.
  template <typename... Args>
  Diagnostic* Report(Code code, SourceRange range, const Args&... args) {
    if (!reported_.insert({static_cast<int>(code), range.file, range.begin}).second) return nullptr;
    return &reporter_.Report(code, range, args...);
  }

  const Options& options_;
  const std::deque<SourceFile>& files_;
  const MacroUses& macros_;
  Reporter& reporter_;
  const LoweringOptions lowering_options_;
  Program program_;
  std::set<std::tuple<int, int, uint32_t>> reported_;
  std::deque<FunctionInfo> functions_;
  std::vector<Scope> scopes_;  // [0]: the globals
  int order_ = 0;
  NameMaker global_names_;
  std::unordered_set<std::string> local_names_;   // of all functions
  std::unordered_map<const void*, int> statics_;  // variables of static locals by declarator
  std::vector<Group> groups_;
  const DepthComment* depth_of_all_ = nullptr;  // of functions that have no comment
  // Those that the program defines; a function that is inlined twice has its own once.
  std::unordered_map<const StructSpecifier*, OwnStructure> structures_;
  std::unordered_map<const gtcalls::Structure*, OwnStructure> card_structures_;
  std::vector<InitialValue> initial_values_;
  // Those before each statement.
  std::unordered_map<const Statement*, std::vector<AssertComment>> asserts_;
  // The globals of start.cc.
  struct Start {
    int ready = -1;
    int entered = -1;
    int written = -1;
    int left = -1;
  };
  Start start_;

  // Of the thread function that is being translated.
  LoweredFunction* out_ = nullptr;
  Frame* frame_ = nullptr;
  NameMaker names_;
  std::unordered_map<std::string, int> written_names_;  // of structures, how often each is wished
  NameMaker label_names_;
  std::unordered_map<const void*, int> variables_;  // by declarator or parameter
  std::deque<SharedBody> bodies_;
  std::map<int, Frames> frames_;  // by group
  std::vector<RecursiveCall> recursive_calls_;
  std::unordered_map<const void*, int> blocks_;  // numbers of those that were translated
  int inlined_ = 0;
  int statement_ = 0;     // the full expression that is being translated
  int instance_ = -1;     // the block that is being translated; -1: none
  bool stopped_ = false;  // it became too long
};

/// `true` for a value that is void, a structure, or follows an error.
inline bool IsVoid(const Value& value) { return value.operand.kind == Operand::Kind::kNone; }

/// What `p++`, `--p`, `p += n` and `p = q` change, nullptr for other expressions.
const Expression* MovesOf(const Expression& expression);

/// The expression inside all parentheses.
const Expression& WithoutParens(const Expression& expression);

}  // namespace oncard::compiler::lowering
