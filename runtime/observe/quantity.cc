#include "runtime/observe/quantity.h"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "base/nearest.h"
#include "base/number.h"
#include "vm/symbol_names.h"

namespace oncard::runtime {
namespace {

using vm::DataType;

struct WordName {
  std::string_view name;
  bool output;
  int number;
};

constexpr std::array kWords = {
    WordName{"limit_positive", false, static_cast<int>(motion::DiType::kLimitPositive)},
    WordName{"limit_negative", false, static_cast<int>(motion::DiType::kLimitNegative)},
    WordName{"alarm", false, static_cast<int>(motion::DiType::kAlarm)},
    WordName{"home", false, static_cast<int>(motion::DiType::kHome)},
    WordName{"gpi", false, static_cast<int>(motion::DiType::kGpi)},
    WordName{"arrive", false, static_cast<int>(motion::DiType::kArrive)},
    WordName{"mpg", false, static_cast<int>(motion::DiType::kMpg)},
    WordName{"enable", true, static_cast<int>(motion::DoType::kEnable)},
    WordName{"clear", true, static_cast<int>(motion::DoType::kClear)},
    WordName{"gpo", true, static_cast<int>(motion::DoType::kGpo)},
};

struct ThreadFieldName {
  std::string_view name;
  QuantityKind kind;
};

constexpr std::array kThreadFields = {
    ThreadFieldName{"run", QuantityKind::kThreadRun},
    ThreadFieldName{"result", QuantityKind::kThreadResult},
    ThreadFieldName{"error", QuantityKind::kThreadError},
    ThreadFieldName{"line", QuantityKind::kThreadLine},
    ThreadFieldName{"page", QuantityKind::kThreadPage},
    ThreadFieldName{"statements", QuantityKind::kThreadStatements},
};

struct PlainName {
  std::string_view name;
  QuantityKind kind;
};

constexpr std::array kPlainNames = {
    PlainName{"clock", QuantityKind::kClock},
    PlainName{"statements", QuantityKind::kStatements},
};

std::optional<int> ParseIndex(std::string_view text) {
  const auto value = ReadWhole<int>(text);
  return value.value_or(-1) < 0 ? std::nullopt : value;
}

// `base[index]`, or `base` alone.
struct IndexedName {
  std::string_view base;
  std::optional<int> index;
};

std::optional<IndexedName> SplitIndex(std::string_view name) {
  const size_t open = name.find('[');
  if (open == std::string_view::npos) return IndexedName{name, std::nullopt};
  if (!name.ends_with(']')) return std::nullopt;
  const auto index = ParseIndex(name.substr(open + 1, name.size() - open - 2));
  if (!index) return std::nullopt;
  return IndexedName{name.substr(0, open), index};
}

/// The global variables; empty if no program is loaded, as on the card of a host program.
std::span<const vm::Symbol> GlobalsOf(const vm::Machine& machine) {
  if (machine.image() == nullptr) return {};
  return machine.image()->object.globals;
}

Error UnknownName(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string_view near = NearestName(name, candidates);
  if (near.empty()) {
    return MakeError(1, "nothing is named '{0}'", "没有名为“{0}”的量", name);
  }
  return MakeError(1, "nothing is named '{0}'; did you mean '{1}'?",
                   "没有名为“{0}”的量；是否为“{1}”？", name, near);
}

// A name that nothing has, with that of a similar variable.
Error UnknownVariable(std::string_view name, std::span<const vm::Symbol> symbols) {
  const std::string_view base = name.substr(0, std::min(name.find_first_of(".["), name.size()));
  Nearest whole(name);
  Nearest beginning(base);
  for (const vm::Symbol& symbol : symbols) {
    whole.Add(symbol.name);
    beginning.Add(vm::NameOfVariable(symbol));
  }
  std::string meant(whole.best());
  if (meant.empty() && !beginning.best().empty()) {
    meant = fmt::format("{}{}", beginning.best(), name.substr(base.size()));
  }
  const std::string_view only[] = {meant};
  return UnknownName(name, only);
}

// Slots of variables, with their names.
std::vector<Quantity> QuantitiesOf(std::span<const vm::NamedSlots> found, std::string_view prefix,
                                   bool global, int page) {
  std::vector<Quantity> quantities;
  for (const vm::NamedSlots& slots : found) {
    const vm::Symbol& symbol = *slots.symbol;
    for (int i = slots.first; i < slots.first + slots.count; ++i) {
      Quantity quantity;
      quantity.kind = QuantityKind::kVariable;
      quantity.slot = {global, static_cast<uint8_t>(page), static_cast<uint16_t>(symbol.id + i),
                       symbol.type};
      quantity.is_part = !slots.is_number;
      quantity.name = fmt::format("{}{}", prefix, vm::NameOfElement(symbol, i));
      quantities.push_back(std::move(quantity));
    }
  }
  return quantities;
}

Result<std::vector<Quantity>> ResolveThread(std::string_view name, int thread,
                                            std::string_view field) {
  if (thread >= vm::kThreadCount) {
    return MakeError(1, "'{0}': threads are numbered 0 to {1}", "“{0}”：线程号为 0 至 {1}", name,
                     vm::kThreadCount - 1);
  }
  std::vector<std::string_view> candidates;
  for (const ThreadFieldName& row : kThreadFields) {
    if (row.name == field) {
      Quantity quantity;
      quantity.name = name;
      quantity.kind = row.kind;
      quantity.thread = thread;
      return std::vector{quantity};
    }
    candidates.push_back(row.name);
  }
  return UnknownName(field, candidates);
}

Error NoProgram() {
  return MakeError(1, "no program is downloaded, so it has no variables", "尚未下载程序，没有变量");
}

// True if a name begins with a local variable of a function.
bool HasLocal(const vm::Image& image, int function, std::string_view name) {
  const auto found =
      vm::FindNamed(image.object.functions[static_cast<size_t>(function)].variables, name);
  return !found.ok() || !found.value().empty();
}

// The function whose locals are on a page.
Result<int> FunctionOnPage(int page, std::string_view variable, const vm::Machine& machine) {
  std::vector<int> having;
  for (const vm::ThreadState& thread : machine.state().threads) {
    if (thread.run == vm::ThreadRun::kUnbound) continue;
    if (thread.page == page) return int{thread.function};
    const bool known = std::find(having.begin(), having.end(), thread.function) != having.end();
    if (!known && HasLocal(*machine.image(), thread.function, variable)) {
      having.push_back(thread.function);
    }
  }
  if (having.size() == 1) return having.front();
  return MakeError(1, "no thread is bound to page {0}, so '{1}' has no meaning there",
                   "没有线程绑定到数据页 {0}，“{1}”在该页没有含义", page, variable);
}

Result<std::vector<Quantity>> ResolveLocal(int page, std::string_view variable,
                                           const vm::Machine& machine) {
  if (page >= vm::kPageCount) {
    return MakeError(1, "'page{0}': pages are numbered 0 to {1}", "“page{0}”：数据页号为 0 至 {1}",
                     page, vm::kPageCount - 1);
  }
  if (machine.image() == nullptr) return NoProgram();
  const auto function = FunctionOnPage(page, variable, machine);
  if (!function.ok()) return function.error();
  const auto& locals =
      machine.image()->object.functions[static_cast<size_t>(function.value())].variables;
  const auto found = vm::FindNamed(locals, variable);
  if (!found.ok()) return found.error();
  if (found.value().empty()) return UnknownVariable(variable, locals);
  return QuantitiesOf(found.value(), fmt::format("page{}.", page), false, page);
}

// "thread12.result" with prefix "thread": 12 and "result".
struct NumberedName {
  int number = 0;
  std::string_view rest;
};

std::optional<NumberedName> SplitNumbered(std::string_view name, std::string_view prefix) {
  const size_t dot = name.find('.');
  if (!name.starts_with(prefix) || dot == std::string_view::npos) return std::nullopt;
  const auto number = ParseIndex(name.substr(prefix.size(), dot - prefix.size()));
  if (!number) return std::nullopt;
  return NumberedName{*number, name.substr(dot + 1)};
}

// "axis1.prfPos", "dac1": the part's name, its number and the name of the value.
struct PartName {
  std::string_view part;
  int number = 0;
  std::string_view value;
};

std::optional<PartName> SplitPart(std::string_view name) {
  const size_t dot = std::min(name.find('.'), name.size());
  const size_t digits = name.find_first_of("0123456789");
  if (digits == 0 || digits >= dot) return std::nullopt;
  const auto number = ParseIndex(name.substr(digits, dot - digits));
  if (!number) return std::nullopt;
  return PartName{name.substr(0, digits), *number, name.substr(std::min(dot + 1, name.size()))};
}

// "spindle.volts": of a part of which a card has one.
std::optional<PartName> SplitUnnumbered(std::string_view name) {
  const size_t dot = std::min(name.find('.'), name.size());
  const MotionPart* part = FindMotionPart(name.substr(0, dot));
  if (part == nullptr || part->first != kUnnumbered) return std::nullopt;
  return PartName{part->name, kUnnumbered, name.substr(std::min(dot + 1, name.size()))};
}

Result<std::vector<Quantity>> ResolveMotion(std::string_view name, const PartName& split,
                                            const MotionPart& part, const Controller& controller) {
  const motion::MotionCore& core = controller.motion();
  const int last = part.first + static_cast<int>(part.count(core)) - 1;
  if (split.number < part.first || split.number > last) {
    return MakeError(1, "'{0}': this card has {1}{2} to {1}{3}", "“{0}”：此卡只有 {1}{2} 至 {1}{3}",
                     name, part.name, part.first, last);
  }
  const auto index = static_cast<size_t>(split.number - part.first);
  if (part.has != nullptr && !part.has(core, index)) {
    return MakeError(1, "'{0}': this card has no {1}", "“{0}”：此卡没有 {1}", name,
                     MotionValueName(part, split.number, {}));
  }
  const MotionValue* value = FindMotionValue(part, split.value);
  if (value == nullptr && split.value.empty()) {
    std::vector<std::string_view> values;
    for (const MotionValue& known : part.values) values.push_back(known.name);
    return MakeError(1, "'{0}' has the values {1}", "“{0}”的量有 {1}", name,
                     fmt::to_string(fmt::join(values, ", ")));
  }
  if (value == nullptr) {
    std::vector<std::string> names;
    for (const MotionValue& known : part.values) {
      names.push_back(MotionValueName(part, split.number, known.name));
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return UnknownName(name, candidates);
  }
  Quantity quantity;
  quantity.name = name;
  quantity.kind = QuantityKind::kMotion;
  quantity.part = &part;
  quantity.value = value;
  quantity.index = index;
  const bool measured = value->unit == Unit::kPulse || value->unit == Unit::kPulsePerMs ||
                        value->unit == Unit::kPulsePerMs2;
  if (part.of_axis && measured && index < core.axis_count()) {
    quantity.axis_unit = controller.options().units[index];
  }
  return std::vector{quantity};
}

// The error for a name with a number whose part is unknown.
Error UnknownPart(std::string_view name, const PartName& split) {
  std::vector<std::string_view> parts = {"thread", "page"};
  for (const MotionPart& part : MotionParts()) parts.push_back(part.name);
  const std::string_view near = NearestName(split.part, parts);
  if (near.empty()) return UnknownName(name, {});
  const std::string meant = fmt::format("{}{}", near, name.substr(split.part.size()));
  const std::string_view only[] = {meant};
  return UnknownName(name, only);
}

int WidthOf(const WordName& word) {
  return word.output ? motion::DoWidth(static_cast<motion::DoType>(word.number))
                     : motion::DiWidth(static_cast<motion::DiType>(word.number));
}

Result<std::vector<Quantity>> ResolveWord(const WordName& word, const IndexedName& name) {
  Quantity quantity;
  quantity.word = word.number;
  quantity.name = word.name;
  quantity.kind = word.output ? QuantityKind::kOutputWord : QuantityKind::kInputWord;
  if (name.index) {
    const int width = WidthOf(word);
    if (*name.index < 1 || *name.index > width) {
      return MakeError(1, "bits of '{0}' are numbered 1 to {1}", "“{0}”的位号为 1 至 {1}",
                       word.name, width);
    }
    quantity.kind = word.output ? QuantityKind::kOutputBit : QuantityKind::kInputBit;
    quantity.name += fmt::format("[{}]", *name.index);
    quantity.bit = *name.index - 1;
  }
  return std::vector{quantity};
}

}  // namespace

Result<std::vector<Quantity>> ResolveQuantity(std::string_view name, const Controller& controller) {
  const vm::Machine& machine = controller.machine();
  if (!vm::IsName(name)) {
    return MakeError(1, "'{0}' is not a name; an index is a number, as in 'a[3]'",
                     "“{0}”不是名称；下标应为数字，如“a[3]”", name);
  }
  const auto variable = vm::FindNamed(GlobalsOf(machine), name);
  if (!variable.ok()) return variable.error();
  if (!variable.value().empty()) return QuantitiesOf(variable.value(), "", true, 0);
  if (const auto thread = SplitNumbered(name, "thread")) {
    return ResolveThread(name, thread->number, thread->rest);
  }
  if (const auto page = SplitNumbered(name, "page")) {
    return ResolveLocal(page->number, page->rest, machine);
  }
  const auto unnumbered = SplitUnnumbered(name);
  const auto part_name = unnumbered ? unnumbered : SplitPart(name);
  if (part_name) {
    if (const MotionPart* part = FindMotionPart(part_name->part)) {
      return ResolveMotion(name, *part_name, *part, controller);
    }
  }
  std::vector<std::string_view> candidates;
  for (const vm::Symbol& global : GlobalsOf(machine)) candidates.push_back(global.name);
  const auto indexed = SplitIndex(name);
  for (const WordName& word : kWords) {
    if (indexed && word.name == indexed->base) return ResolveWord(word, *indexed);
    candidates.push_back(word.name);
  }
  for (const PlainName& row : kPlainNames) {
    if (row.name == name) {
      Quantity quantity;
      quantity.name = name;
      quantity.kind = row.kind;
      return std::vector{quantity};
    }
    candidates.push_back(row.name);
  }
  if (!NearestName(name, candidates).empty()) return UnknownName(name, candidates);
  if (part_name) return UnknownPart(name, *part_name);
  return UnknownVariable(name, GlobalsOf(machine));
}

std::string NameInThread(std::string_view name, int thread, const Controller& controller) {
  const vm::Machine& machine = controller.machine();
  const vm::ThreadState& state = machine.thread(thread);
  const bool local =
      state.run != vm::ThreadRun::kUnbound && HasLocal(*machine.image(), state.function, name);
  return local ? fmt::format("page{}.{}", state.page, name) : std::string(name);
}

bool IsOfProgram(QuantityKind kind) {
  switch (kind) {
    case QuantityKind::kVariable:
    case QuantityKind::kThreadRun:
    case QuantityKind::kThreadResult:
    case QuantityKind::kThreadError:
    case QuantityKind::kThreadLine:
    case QuantityKind::kThreadPage:
    case QuantityKind::kThreadStatements:
      return true;
    case QuantityKind::kInputWord:
    case QuantityKind::kInputBit:
    case QuantityKind::kOutputWord:
    case QuantityKind::kOutputBit:
    case QuantityKind::kMotion:
    case QuantityKind::kClock:
    case QuantityKind::kStatements:
      break;
  }
  return false;
}

std::vector<Quantity> GlobalQuantities(const Controller& controller) {
  return QuantitiesOf(vm::AllInOrder(GlobalsOf(controller.machine())), "", true, 0);
}

std::vector<Quantity> LocalQuantities(int function, int page, const Controller& controller) {
  const vm::Object& object = controller.machine().image()->object;
  return QuantitiesOf(vm::AllInOrder(object.functions[static_cast<size_t>(function)].variables),
                      fmt::format("page{}.", page), false, page);
}

double ReadQuantity(const Quantity& quantity, const Controller& controller) {
  const vm::Machine& machine = controller.machine();
  const vm::ThreadState& thread = machine.thread(quantity.thread);
  const motion::DigitalIo& io = controller.motion().state().io;
  switch (quantity.kind) {
    case QuantityKind::kVariable:
      return machine.Read(quantity.slot);
    case QuantityKind::kThreadRun:
      // The values of TThreadSts.run.
      return thread.run == vm::ThreadRun::kRunning  ? 1
             : thread.run == vm::ThreadRun::kPaused ? 2
                                                    : 0;
    case QuantityKind::kThreadResult:
      return thread.result_type == DataType::kDouble ? vm::DoubleFromFixed(thread.result)
                                                     : static_cast<double>(thread.result);
    case QuantityKind::kThreadError:
      return thread.error;
    case QuantityKind::kThreadLine:
      return machine.Line(quantity.thread);
    case QuantityKind::kThreadPage:
      return thread.page;
    case QuantityKind::kThreadStatements:
      return static_cast<double>(thread.executed);
    case QuantityKind::kInputWord:
      return io.Read(static_cast<motion::DiType>(quantity.word));
    case QuantityKind::kInputBit:
      return (io.Read(static_cast<motion::DiType>(quantity.word)) >> quantity.bit) & 1u;
    case QuantityKind::kOutputWord:
      return io.Register(static_cast<motion::DoType>(quantity.word));
    case QuantityKind::kOutputBit:
      return (io.Register(static_cast<motion::DoType>(quantity.word)) >> quantity.bit) & 1u;
    case QuantityKind::kMotion:
      return quantity.Shown(quantity.value->read(controller.view(), quantity.index));
    case QuantityKind::kClock:
      return static_cast<double>(controller.motion().ClockMs());
    case QuantityKind::kStatements:
      return static_cast<double>(machine.state().executed);
  }
  return 0;
}

NumberForm FormOfQuantity(const Quantity& quantity, const Controller& controller) {
  switch (quantity.kind) {
    case QuantityKind::kVariable:
      return FormOf(quantity.slot.type);
    case QuantityKind::kThreadResult:
      return FormOf(controller.machine().thread(quantity.thread).result_type);
    case QuantityKind::kMotion:
      return quantity.value->form;
    case QuantityKind::kInputBit:
    case QuantityKind::kOutputBit:
      return NumberForm::kFlag;
    default:
      return NumberForm::kWhole;
  }
}

NumberForm FormOf(DataType type) {
  return type == DataType::kDouble ? NumberForm::kFixedPoint : NumberForm::kWhole;
}

std::string FormatNumber(double value, NumberForm form) {
  std::string text;
  AppendNumber(value, form, &text);
  return text;
}

void AppendNumber(double value, NumberForm form, std::string* text) {
  const auto out = std::back_inserter(*text);
  const size_t begin = text->size();
  switch (form) {
    case NumberForm::kWhole:
    case NumberForm::kFlag:
      fmt::format_to(out, FMT_COMPILE("{}"), static_cast<int64_t>(value));
      return;
    case NumberForm::kFixedPoint:
      // Up to 16 decimal places, because numbers without an exponent are required.
      fmt::format_to(out, FMT_COMPILE("{:.16f}"), value);
      text->erase(text->find_last_not_of('0') + 1);
      if (text->ends_with('.')) *text += '0';
      return;
    case NumberForm::kReal:
      fmt::format_to(out, FMT_COMPILE("{}"), value);
      if (text->find_first_of(".en", begin) == std::string::npos) *text += ".0";
      return;
  }
}

std::span<const std::string_view> WordNames() {
  static constexpr auto kNames = [] {
    std::array<std::string_view, kWords.size()> names;
    for (size_t i = 0; i < names.size(); ++i) names[i] = kWords[i].name;
    return names;
  }();
  return kNames;
}

std::optional<motion::DiType> FindInputWord(std::string_view name) {
  for (const WordName& word : kWords) {
    if (!word.output && word.name == name) return static_cast<motion::DiType>(word.number);
  }
  return std::nullopt;
}

int WordWidth(std::string_view name) {
  for (const WordName& word : kWords) {
    if (word.name == name) return WidthOf(word);
  }
  return 0;
}

std::string_view InputWordName(motion::DiType type) {
  for (const WordName& word : kWords) {
    if (!word.output && word.number == static_cast<int>(type)) return word.name;
  }
  return {};
}

}  // namespace oncard::runtime
