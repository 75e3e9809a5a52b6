// `switch`: the value is compared with each case in turn, then the body follows as it is, so that
// cases fall through and may stand anywhere in it.
#include <fmt/core.h>

#include <functional>

#include "compiler/lowering/lowerer.h"

namespace oncard::compiler::lowering {
namespace {

// Calls `visit` for the cases of a switch, not for those of a switch inside it.
void ForEachCase(const Statement& statement, const std::function<void(const Statement&)>& visit) {
  if (statement.kind == Statement::Kind::kCase || statement.kind == Statement::Kind::kDefault) {
    visit(statement);
  }
  for (const Statement* below : {statement.body.get(), statement.else_body.get()}) {
    if (below != nullptr && below->kind != Statement::Kind::kSwitch) ForEachCase(*below, visit);
  }
  for (const StatementPtr& item : statement.items) {
    if (item->kind != Statement::Kind::kSwitch) ForEachCase(*item, visit);
  }
}

// `3`, or `m3` for -3, in a label.
std::string SpellCase(int64_t value) {
  return value < 0 ? fmt::format("m{}", -value) : fmt::format("{}", value);
}

}  // namespace

void Lowerer::LowerSwitch(const Statement& statement) {
  struct Range {
    int64_t first;
    int64_t last;
    const Statement* item;
    int label;
    SourceRange place;
  };
  std::vector<Range> ranges;
  int default_label = -1;
  std::unordered_map<const Statement*, int> labels;
  const SourceRange keyword = statement.keyword;
  const BasicType type = Promoted(TypeOf(*statement.value));
  ForEachCase(*statement.body, [&](const Statement& item) {
    if (item.kind == Statement::Kind::kDefault) {
      if (default_label >= 0) {
        Report(Code::kCaseLabel, item.range,
               MakeMessage("the 'switch' has another 'default'", "该 'switch' 已有 'default'"));
        return;
      }
      default_label = NewLabel("switch", keyword, "default");
      labels.emplace(&item, default_label);
      return;
    }
    const std::optional<int64_t> first = EvaluateInteger(*item.value);
    const std::optional<int64_t> last = item.last != nullptr ? EvaluateInteger(*item.last) : first;
    if (!first || !last) {
      Report(Code::kCaseLabel, item.value->range,
             MakeMessage("its value is not an integer constant", "其值不是整数常量"));
      return;
    }
    Range range = {*first, *last, &item, -1, item.range};
    if (range.first > range.last) {
      Report(Code::kCaseLabel, item.range, MakeMessage("its range is empty", "其范围为空"));
      return;
    }
    for (const Range& other : ranges) {
      if (range.first > other.last || range.last < other.first) continue;
      Report(Code::kCaseLabel, item.range,
             MakeMessage("line {0} has a case of the same value", "第 {0} 行已有相同值的分支",
                         LineOf(other.place)));
      return;
    }
    const std::string part = fmt::format("case_{}", SpellCase(range.first));
    range.label = NewLabel("switch", keyword, part);
    labels.emplace(&item, range.label);
    ranges.push_back(range);
  });
  const int end = NewLabel("switch", keyword, "end");
  BeginFullExpression(statement.value->range);
  Value value = LowerValue(*statement.value);
  if (RequireNumber(value, *statement.value)) {
    if (value.type == BasicType::kDouble) {
      Report(Code::kTypeMismatch, statement.value->range, MakeMessage("a double", "double"),
             MakeMessage("an int in 'switch'", "'switch' 中的 int"),
             MakeMessage("convert it: (int)", "请转换：(int)"));
    }
    value = Load(Convert(value, type, statement.value->range), statement.value->range);
    const auto compare = [&](vm::BinaryOperator op, int64_t number, const Expression& written,
                             SourceRange range) {
      Value constant = {IntOperand(number), type, type};
      KeepSpelling(written, constant.operand);
      const bool relation = op != vm::BinaryOperator::kEqual;
      if (relation && type == BasicType::kUnsigned) {
        return CompareUnsigned(op, value, constant, range).operand;
      }
      return Compute(op, value.operand, constant.operand, BasicType::kInt, range).operand;
    };
    for (const Range& range : ranges) {
      if (range.first == range.last) {
        EmitIf(compare(vm::BinaryOperator::kEqual, range.first, *range.item->value, range.place),
               range.label, range.place);
        continue;
      }
      const int skip = NewLabel("switch", keyword, "next");
      EmitIf(compare(vm::BinaryOperator::kLess, range.first, *range.item->value, range.place), skip,
             range.place);
      EmitIf(compare(vm::BinaryOperator::kLessEqual, range.last, *range.item->last, range.place),
             range.label, range.place);
      EmitLabel(skip, statement.value->range);
    }
    EmitGoto(default_label >= 0 ? default_label : end, statement.value->range);
  }
  const int outer = frame_->targets.empty() ? -1 : frame_->targets.back().continue_label;
  frame_->targets.push_back({end, outer});
  frame_->cases.push_back(std::move(labels));
  LowerInner(*statement.body);
  frame_->cases.pop_back();
  frame_->targets.pop_back();
  EmitLabel(end, statement.range);
}

}  // namespace oncard::compiler::lowering
