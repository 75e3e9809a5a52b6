#include "vm/symbol_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/nearest.h"
#include "base/number.h"
#include "vm/limits.h"

namespace oncard::vm {
namespace {

// `name[2][3]` between the dots of a name: in a symbol the numbers are sizes, else indices.
struct Part {
  std::string_view name;
  std::vector<int> numbers;
};

// The parts of a name; empty for a text that is none.
std::vector<Part> Split(std::string_view text) {
  std::vector<Part> parts;
  while (true) {
    const size_t end = std::min(text.find_first_of(".["), text.size());
    Part part = {text.substr(0, end), {}};
    text.remove_prefix(end);
    while (text.starts_with('[')) {
      const size_t close = text.find(']');
      if (close == std::string_view::npos) return {};
      const auto number = ReadWhole<int>(text.substr(1, close - 1));
      if (number.value_or(-1) < 0) return {};
      part.numbers.push_back(*number);
      text.remove_prefix(close + 1);
    }
    parts.push_back(std::move(part));
    if (text.empty()) return parts;
    if (!text.starts_with('.')) return {};
    text.remove_prefix(1);
  }
}

std::vector<Part> PartsOf(const Symbol& symbol) {
  if (!symbol.written.empty()) return Split(symbol.written);
  std::vector<Part> parts = Split(symbol.name);
  if (symbol.array_size != 0 && !parts.empty()) parts.back().numbers = {symbol.array_size};
  return parts;
}

// The text of the first parts of a name, of the last one without indices.
std::string Join(std::span<const Part> parts) {
  std::string text;
  for (size_t i = 0; i < parts.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : ".", parts[i].name);
    if (i + 1 == parts.size()) break;
    for (const int number : parts[i].numbers) text += fmt::format("[{}]", number);
  }
  return text;
}

Error NoElement(const std::string& name, int size, int index) {
  return MakeError(1, "'{0}' has elements 0 to {1}, not {2}", "“{0}”的下标为 0 至 {1}，没有 {2}",
                   name, size - 1, index);
}

Error NoArray(const std::string& name) {
  return MakeError(1, "'{0}' is not an array", "“{0}”不是数组", name);
}

// How many parts of a name lead into a symbol.
size_t Common(std::span<const Part> wanted, std::span<const Part> parts) {
  size_t common = 0;
  while (common < wanted.size() && common < parts.size() &&
         wanted[common].name == parts[common].name) {
    ++common;
  }
  return common;
}

// The slots of a symbol that a name of C names, all of whose parts lead into it.
Result<NamedSlots> SlotsAt(std::span<const Part> wanted, std::span<const Part> parts,
                           const Symbol& symbol) {
  NamedSlots slots;
  slots.symbol = &symbol;
  slots.is_number = wanted.size() == parts.size();
  int first = 0;
  int count = 1;
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::vector<int> none;
    const std::vector<int>& indices = i < wanted.size() ? wanted[i].numbers : none;
    const std::vector<int>& sizes = parts[i].numbers;
    const std::string name = Join(wanted.first(std::min(i + 1, wanted.size())));
    if (indices.size() > sizes.size()) return NoArray(Join(wanted.first(i + 1)));
    if (i + 1 < wanted.size() && indices.size() < sizes.size()) {
      return MakeError(1, "'{0}' is an array of {1} elements: write one of them, such as '{0}[0]'",
                       "“{0}”是有 {1} 个元素的数组：应写其中一个，如“{0}[0]”", name,
                       sizes[indices.size()]);
    }
    for (size_t j = 0; j < sizes.size(); ++j) {
      const bool known = j < indices.size();
      if (known && indices[j] >= sizes[j]) return NoElement(name, sizes[j], indices[j]);
      first = first * sizes[j] + (known ? indices[j] : 0);
      if (known) continue;
      count *= sizes[j];
      slots.is_number = false;
    }
  }
  slots.first = static_cast<uint16_t>(first);
  slots.count = static_cast<uint16_t>(count);
  return slots;
}

// The error for a name whose first parts are known, and the next one is not; empty if what they
// name has no members.
std::optional<Error> NoMember(std::span<const Part> wanted, size_t known,
                              std::span<const Symbol> symbols) {
  std::vector<std::string> members;
  for (const Symbol& symbol : symbols) {
    const std::vector<Part> parts = PartsOf(symbol);
    if (Common(wanted, parts) < known || parts.size() == known) continue;
    const std::string member(parts[known].name);
    if (std::ranges::find(members, member) == members.end()) members.push_back(member);
  }
  if (members.empty()) return std::nullopt;
  std::string whole = Join(wanted.first(known));
  for (const int index : wanted[known - 1].numbers) whole += fmt::format("[{}]", index);
  const std::string_view wrong = wanted[known].name;
  Nearest nearest(wrong);
  for (const std::string& member : members) nearest.Add(member);
  if (!nearest.best().empty()) {
    return MakeError(1, "'{0}' has no member '{1}'; did you mean '{2}'?",
                     "“{0}”没有成员“{1}”；是否为“{2}”？", whole, wrong, nearest.best());
  }
  return MakeError(1, "'{0}' has no member '{1}': it has {2}", "“{0}”没有成员“{1}”：只有 {2}",
                   whole, wrong, fmt::to_string(fmt::join(members, ", ")));
}

// A name of an element with its indices, to put elements into the order of C.
struct NamedElement {
  NamedSlots slot;
  size_t symbol = 0;
  std::string name;
};

bool IsBefore(const NamedElement& a, const NamedElement& b) {
  const std::vector<Part> left = Split(a.name);
  const std::vector<Part> right = Split(b.name);
  for (size_t i = 0; i < left.size() && i < right.size() && left[i].name == right[i].name; ++i) {
    if (left[i].numbers != right[i].numbers) return left[i].numbers < right[i].numbers;
  }
  return a.symbol < b.symbol;
}

// The elements of several symbols in the order of C: `a[0].x, a[0].y, a[1].x`.
std::vector<NamedSlots> OneByOne(const std::vector<NamedSlots>& found) {
  std::vector<NamedElement> elements;
  for (size_t symbol = 0; symbol < found.size(); ++symbol) {
    for (int i = 0; i < found[symbol].count; ++i) {
      NamedSlots slot = found[symbol];
      slot.first = static_cast<uint16_t>(slot.first + i);
      slot.count = 1;
      elements.push_back({slot, symbol, NameOfElement(*slot.symbol, slot.first)});
    }
  }
  std::ranges::sort(elements, IsBefore);
  std::vector<NamedSlots> slots;
  slots.reserve(elements.size());
  for (const NamedElement& element : elements) slots.push_back(element.slot);
  return slots;
}

// A symbol itself, with at most one index; empty for another name.
std::optional<Result<std::vector<NamedSlots>>> FindSymbol(std::span<const Symbol> symbols,
                                                          std::string_view name,
                                                          std::span<const Part> wanted) {
  const std::vector<int>& indices = wanted.back().numbers;
  if (indices.size() > 1) return std::nullopt;
  const std::string_view base = name.substr(0, std::min(name.find('['), name.size()));
  const auto found = std::ranges::find(symbols, base, &Symbol::name);
  if (found == symbols.end() || Join(wanted) != base) return std::nullopt;
  NamedSlots slots = {&*found, 0, found->slots(), indices.size() == 1 || found->array_size == 0};
  if (indices.empty()) return std::vector{slots};
  if (found->array_size == 0) return NoArray(found->name);
  if (indices[0] >= found->array_size) {
    return NoElement(found->name, found->array_size, indices[0]);
  }
  slots.first = static_cast<uint16_t>(indices[0]);
  slots.count = 1;
  return std::vector{slots};
}

}  // namespace

bool IsIdentifier(std::string_view text) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

bool IsName(std::string_view text) { return !Split(text).empty(); }

bool IsWrittenName(const Symbol& symbol) {
  const std::vector<Part> parts = Split(symbol.written);
  int64_t elements = 1;
  bool is_array = false;
  for (const Part& part : parts) {
    if (!IsIdentifier(part.name)) return false;
    for (const int size : part.numbers) {
      if (size < 1 || size > kSlotCount) return false;
      is_array = true;
      elements = std::min(elements * size, int64_t{kSlotCount} + 1);
    }
  }
  return !parts.empty() && is_array == (symbol.array_size != 0) && elements == symbol.slots();
}

Result<std::vector<NamedSlots>> FindNamed(std::span<const Symbol> symbols, std::string_view name) {
  std::vector<NamedSlots> found;
  const std::vector<Part> wanted = Split(name);
  if (wanted.empty()) return found;
  if (auto symbol = FindSymbol(symbols, name, wanted)) return *std::move(symbol);
  size_t known = 0;
  for (const Symbol& symbol : symbols) {
    const std::vector<Part> parts = PartsOf(symbol);
    const size_t common = Common(wanted, parts);
    known = std::max(known, common);
    if (common < wanted.size()) continue;
    const auto slots = SlotsAt(wanted, parts, symbol);
    if (!slots.ok()) return slots.error();
    found.push_back(slots.value());
  }
  if (found.empty() && known > 0) {
    if (auto error = NoMember(wanted, known, symbols)) return *std::move(error);
  }
  return found.size() > 1 ? OneByOne(found) : found;
}

std::vector<NamedSlots> AllInOrder(std::span<const Symbol> symbols) {
  std::vector<NamedSlots> all;
  for (size_t i = 0; i < symbols.size();) {
    const std::string_view name = NameOfVariable(symbols[i]);
    std::vector<NamedSlots> variable;
    do {
      const Symbol& symbol = symbols[i];
      variable.push_back({&symbol, 0, symbol.slots(), symbol.array_size == 0});
      ++i;
    } while (i < symbols.size() && NameOfVariable(symbols[i]) == name);
    if (variable.size() > 1) variable = OneByOne(variable);
    all.insert(all.end(), variable.begin(), variable.end());
  }
  return all;
}

std::string NameOfElement(const Symbol& symbol, int element) {
  if (symbol.written.empty()) {
    return symbol.array_size == 0 ? symbol.name : fmt::format("{}[{}]", symbol.name, element);
  }
  std::vector<Part> parts = Split(symbol.written);
  for (size_t i = parts.size(); i-- > 0;) {
    for (size_t j = parts[i].numbers.size(); j-- > 0;) {
      int& number = parts[i].numbers[j];
      const int size = std::max(number, 1);
      number = element % size;
      element /= size;
    }
  }
  std::string name;
  for (const Part& part : parts) {
    name += fmt::format("{}{}", name.empty() ? "" : ".", part.name);
    for (const int number : part.numbers) name += fmt::format("[{}]", number);
  }
  return name;
}

std::string_view NameOfVariable(const Symbol& symbol) {
  const std::string_view name = symbol.written.empty() ? symbol.name : symbol.written;
  return name.substr(0, std::min(name.find_first_of(".["), name.size()));
}

}  // namespace oncard::vm
