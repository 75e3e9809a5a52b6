#include "explore/models/property.h"

#include <algorithm>

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <optional>

#include "base/nearest.h"
#include "base/number.h"
#include "vm/fixed_point.h"

namespace oncard::explore {
namespace {

bool IsNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

std::optional<int> ParseNumber(std::string_view text) {
  const auto value = ReadWhole<int>(text);
  return value.value_or(-1) < 0 ? std::nullopt : value;
}

}  // namespace

/// The names of a program's variables and results.
class ModelNames {
 public:
  using Kind = Property::Kind;
  using Element = Property::Element;

  explicit ModelNames(const Model& model) : model_(model) {}

  Result<Element> Find(std::string_view name, std::optional<int> index, Property*) const {
    const vm::Symbol* global = vm::FindGlobal(model_.image(), name);
    if (global != nullptr) return Slot(*global, index, true, 0);
    for (const std::string_view prefix : {"ret", "thread"}) {
      if (!name.starts_with(prefix)) continue;
      std::string_view digits = name.substr(prefix.size());
      if (prefix == "thread") {
        if (!digits.ends_with(".result")) continue;
        digits.remove_suffix(std::string_view(".result").size());
      }
      if (const auto number = ParseNumber(digits)) return Returned(name, *number);
    }
    if (name.starts_with("page")) {
      const size_t dot = name.find('.');
      const auto page =
          dot == std::string_view::npos ? std::nullopt : ParseNumber(name.substr(4, dot - 4));
      if (page) return Local(*page, name.substr(dot + 1), index);
    }
    return Unknown(name);
  }

 private:
  Result<Element> Returned(std::string_view name, int number) const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (model_.setup(thread).thread != number) continue;
      const auto function = static_cast<size_t>(model_.setup(thread).function);
      return Element{.kind = Kind::kReturn,
                     .thread = thread,
                     .type = model_.image().object.functions[function].return_type};
    }
    return MakeError(1, "'{0}': there is no thread {1}", "“{0}”：没有线程 {1}", name, number);
  }

  Result<Element> Local(int page, std::string_view name, std::optional<int> index) const {
    for (int thread = 0; thread < model_.thread_count(); ++thread) {
      if (model_.setup(thread).page != page) continue;
      const vm::Symbol* symbol = vm::FindLocal(model_.image(), model_.setup(thread).function, name);
      if (symbol == nullptr) break;
      return Slot(*symbol, index, false, page);
    }
    return MakeError(1, "no thread has a variable '{0}' on page {1}", "数据页 {1} 上没有变量“{0}”",
                     name, page);
  }

  Result<Element> Slot(const vm::Symbol& symbol, std::optional<int> index, bool global,
                       int page) const {
    if (index.has_value() != (symbol.array_size != 0) || index.value_or(0) >= symbol.slots()) {
      return MakeError(1, "'{0}' has {1} elements: write an index below that in brackets",
                       "“{0}”有 {1} 个元素：请在方括号中写出下标", symbol.name, symbol.array_size);
    }
    vm::SlotAddress slot;
    slot.global = global;
    slot.page = static_cast<uint8_t>(page);
    slot.id = static_cast<uint16_t>(symbol.id + index.value_or(0));
    slot.type = symbol.type;
    return Element{.kind = Kind::kSlot, .slot = slot, .type = symbol.type};
  }

  Result<Element> Unknown(std::string_view name) const {
    Nearest nearest(name);
    for (const vm::Symbol& symbol : model_.image().object.globals) nearest.Add(symbol.name);
    if (!nearest.best().empty()) {
      return MakeError(1, "there is no variable '{0}'; did you mean '{1}'?",
                       "没有变量“{0}”；是否想写“{1}”？", name, nearest.best());
    }
    return MakeError(1, "there is no variable '{0}'", "没有变量“{0}”", name);
  }

  const Model& model_;
};

/// The names of what can be observed of a card; `retN` stands for `threadN.result`.
class CardNames {
 public:
  using Kind = Property::Kind;
  using Element = Property::Element;

  explicit CardNames(const runtime::Controller& controller) : controller_(controller) {}

  Result<Element> Find(std::string_view name, std::optional<int> index, Property* property) const {
    std::string full(name);
    const bool global = vm::FindGlobal(*controller_.machine().image(), name) != nullptr;
    if (!global && name.starts_with("ret") && ParseNumber(name.substr(3))) {
      full = fmt::format("thread{}.result", name.substr(3));
    }
    if (index) full += fmt::format("[{}]", *index);
    auto found = runtime::ResolveQuantity(full, controller_);
    if (!found.ok()) return found.error();
    if (found.value().size() != 1) {
      return MakeError(1, "'{0}' has {1} elements: write an index below that in brackets",
                       "“{0}”有 {1} 个元素：请在方括号中写出下标", full, found.value().size());
    }
    property->quantities_.push_back(std::move(found.value().front()));
    return Element{.kind = Kind::kQuantity, .quantity = property->quantities_.size() - 1};
  }

 private:
  const runtime::Controller& controller_;
};

/// Recursive descent; each level appends to the property's elements.
template <typename Names>
class PropertyParser {
 public:
  using Kind = Property::Kind;
  using Element = Property::Element;

  PropertyParser(std::string_view text, Names names) : text_(text), names_(names) {
    property_.text_ = text;
  }

  Result<Property> Parse() {
    Level(0);
    SkipSpace();
    if (!failed_ && at_ != text_.size()) {
      Fail(MakeMessage("'{0}' is not expected in '{1}'", "“{1}”中不应出现“{0}”",
                       text_.substr(at_, 1), text_));
    }
    if (failed_) return Error{1, reason_};
    return std::move(property_);
  }

 private:
  struct Operator {
    std::string_view text;
    Kind kind;
    int level;
  };
  /// Longer spellings first.
  static constexpr std::array<Operator, 11> kOperators = {{{"||", Kind::kOr, 0},
                                                           {"&&", Kind::kAnd, 1},
                                                           {"==", Kind::kEqual, 2},
                                                           {"!=", Kind::kNotEqual, 2},
                                                           {"<=", Kind::kLessEqual, 3},
                                                           {">=", Kind::kGreaterEqual, 3},
                                                           {"<", Kind::kLess, 3},
                                                           {">", Kind::kGreater, 3},
                                                           {"+", Kind::kAdd, 4},
                                                           {"-", Kind::kSubtract, 4},
                                                           {"*", Kind::kMultiply, 5}}};
  static constexpr int kUnaryLevel = 6;

  void Fail(Message reason) {
    if (!failed_) reason_ = std::move(reason);
    failed_ = true;
  }
  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool Take(std::string_view token) {
    SkipSpace();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }
  void Append(const Element& element) {
    if (failed_) return;
    property_.elements_.push_back(element);
    if (property_.elements_.size() <= Property::kElementMax) return;
    Fail(MakeMessage("'{0}' is too long: at most {1} names, numbers and operators",
                     "“{0}”过长：名称、数字和运算符最多 {1} 个", Beginning(),
                     Property::kElementMax));
  }
  /// What a message quotes of a text that is too long.
  std::string Beginning() const {
    constexpr size_t kQuoted = 40;
    return std::string(text_.substr(0, kQuoted)) + (text_.size() > kQuoted ? "..." : "");
  }

  /// Operators of a level, from the left; operands are of the next level.
  void Level(int level) {
    if (level == kUnaryLevel) return Unary();
    Level(level + 1);
    while (!failed_) {
      const Operator* found = nullptr;
      for (const Operator& candidate : kOperators) {
        if (candidate.level == level && Take(candidate.text)) {
          found = &candidate;
          break;
        }
      }
      if (found == nullptr) return;
      Level(level + 1);
      Append({.kind = found->kind});
    }
  }

  void Unary() {
    if (nesting_ > Property::kNestingMax) {
      return Fail(MakeMessage(
          "'{0}' is nested too deeply: at most {1} parentheses, '!' and '-' inside each other",
          "“{0}”嵌套过深：括号、“!”和“-”最多 {1} 层", Beginning(), Property::kNestingMax));
    }
    ++nesting_;
    if (Take("!")) {
      Unary();
      Append({.kind = Kind::kNot});
    } else if (Take("-")) {
      Unary();
      Append({.kind = Kind::kNegate});
    } else if (Take("(")) {
      Level(0);
      if (!Take(")")) Fail(MakeMessage("')' is missing in '{0}'", "“{0}”中缺少“)”", text_));
    } else {
      Primary();
    }
    --nesting_;
  }

  void Primary() {
    SkipSpace();
    const size_t begin = at_;
    while (at_ < text_.size() && IsNameCharacter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (word.empty()) {
      return Fail(MakeMessage("a variable or a number is missing in '{0}'", "“{0}”中缺少变量或数字",
                              text_));
    }
    if (const auto number = ReadNumber(word)) {
      return Append({.kind = Kind::kNumber, .number = *number});
    }
    const std::optional<int> index = Subscript();
    if (failed_) return;
    const auto element = names_.Find(word, index, &property_);
    if (!element.ok()) return Fail(element.error().message);
    Append(element.value());
  }

  std::optional<int> Subscript() {
    if (!Take("[")) return std::nullopt;
    SkipSpace();
    const size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != ']') ++at_;
    const auto index = ParseNumber(text_.substr(begin, at_ - begin));
    if (!index || !Take("]")) {
      Fail(MakeMessage("an index in '{0}' is not a number", "“{0}”中的下标不是数字", text_));
    }
    return index;
  }

  std::string_view text_;
  Names names_;
  Property property_;
  size_t at_ = 0;
  int nesting_ = 0;
  bool failed_ = false;
  Message reason_;
};

Result<Property> Property::Parse(std::string_view text, const Model& model) {
  return PropertyParser(text, ModelNames(model)).Parse();
}

Result<Property> Property::Parse(std::string_view text, const runtime::Controller& controller) {
  return PropertyParser(text, CardNames(controller)).Parse();
}

bool Property::SeesLocals() const {
  return std::ranges::any_of(elements_, [](const Element& element) {
    return element.kind == Kind::kSlot && !element.slot.global;
  });
}

bool Property::Holds(const Model& model) const {
  return Evaluate([&](const Element& element) {
    const int64_t raw = element.kind == Kind::kReturn ? model.ReturnValue(element.thread)
                                                      : model.Read(element.slot);
    return element.type == vm::DataType::kDouble ? vm::DoubleFromFixed(raw)
                                                 : static_cast<double>(static_cast<int32_t>(raw));
  });
}

bool Property::Holds(const runtime::Controller& controller) const {
  return Evaluate([&](const Element& element) {
    return runtime::ReadQuantity(quantities_[element.quantity], controller);
  });
}

Message Property::DescribeValues(const runtime::Controller& controller) const {
  std::vector<std::string_view> named;
  Message values;
  for (const runtime::Quantity& quantity : quantities_) {
    if (std::ranges::find(named, quantity.name) != named.end()) continue;
    const std::string value = runtime::FormatNumber(runtime::ReadQuantity(quantity, controller),
                                                    runtime::FormOfQuantity(quantity, controller));
    values.en += fmt::format("{}{} is {}", named.empty() ? "" : ", ", quantity.name, value);
    values.zh += fmt::format("{}{} 为 {}", named.empty() ? "" : "，", quantity.name, value);
    named.push_back(quantity.name);
  }
  return values;
}

template <typename Value>
bool Property::Evaluate(Value value) const {
  std::array<double, kElementMax> stack{};
  size_t top = 0;
  for (const Element& element : elements_) {
    switch (element.kind) {
      case Kind::kNumber:
        stack[top++] = element.number;
        continue;
      case Kind::kSlot:
      case Kind::kReturn:
      case Kind::kQuantity:
        stack[top++] = value(element);
        continue;
      case Kind::kNot:
        stack[top - 1] = stack[top - 1] == 0 ? 1 : 0;
        continue;
      case Kind::kNegate:
        stack[top - 1] = -stack[top - 1];
        continue;
      default:
        break;
    }
    const double right = stack[--top];
    double& left = stack[top - 1];
    switch (element.kind) {
      case Kind::kOr:
        left = left != 0 || right != 0 ? 1 : 0;
        break;
      case Kind::kAnd:
        left = left != 0 && right != 0 ? 1 : 0;
        break;
      case Kind::kEqual:
        left = left == right ? 1 : 0;
        break;
      case Kind::kNotEqual:
        left = left != right ? 1 : 0;
        break;
      case Kind::kLess:
        left = left < right ? 1 : 0;
        break;
      case Kind::kLessEqual:
        left = left <= right ? 1 : 0;
        break;
      case Kind::kGreater:
        left = left > right ? 1 : 0;
        break;
      case Kind::kGreaterEqual:
        left = left >= right ? 1 : 0;
        break;
      case Kind::kAdd:
        left += right;
        break;
      case Kind::kSubtract:
        left -= right;
        break;
      default:
        left *= right;
        break;
    }
  }
  return stack[0] != 0;
}

}  // namespace oncard::explore
