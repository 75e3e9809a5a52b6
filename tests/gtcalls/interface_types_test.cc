// The build fails here if a prototype or structure of gts.h differs from the catalogue's row:
// types, their order, and which arguments are optional. The prototypes with a card number need no
// separate check: the library's definitions are compiled with them.
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "gtcalls/gts/rows.h"

// Last, because its constants are macros.
#include "LookAheadEx.h"

namespace oncard::gtcalls::gts {
namespace {

// The table's structure for a type of gts.h; nullptr for any other type.
template <typename T>
constexpr const Structure* StructureOf() {
#define STRUCTURE(name, ...) \
  if (std::is_same_v<T, ::name>) return &structures::name;
#include "gtcalls/gts/structures.def"
  return nullptr;
}

template <typename T>
constexpr bool IsScalar(Scalar scalar) {
  switch (scalar) {
    case Scalar::kChar:
      return std::is_same_v<T, char>;
    case Scalar::kUnsignedChar:
      return std::is_same_v<T, unsigned char>;
    case Scalar::kShort:
      return std::is_same_v<T, short>;
    case Scalar::kUnsignedShort:
      return std::is_same_v<T, unsigned short>;
    case Scalar::kInt:
      return std::is_same_v<T, int>;
    case Scalar::kLong:
      return std::is_same_v<T, long>;
    case Scalar::kUnsignedLong:
      return std::is_same_v<T, unsigned long>;
    case Scalar::kDouble:
      return std::is_same_v<T, double>;
  }
  return false;
}

template <typename T>
constexpr bool Agrees(const Parameter& parameter) {
  using Target = std::remove_pointer_t<T>;
  switch (parameter.passing) {
    case Passing::kValue:
      return parameter.type_name.empty() ? IsScalar<T>(parameter.type) : std::is_enum_v<T>;
    case Passing::kText:
      return std::is_same_v<T, const char*>;
    case Passing::kTextOutput:
      return std::is_same_v<T, char**>;
    case Passing::kHandler:
      return std::is_function_v<Target>;
    case Passing::kHandle:
      return std::is_same_v<T, void*>;
    case Passing::kInput:
    case Passing::kOutput:
    case Passing::kLent:
    case Passing::kHostMemory:
    case Passing::kResult:
      break;
  }
  if (!std::is_pointer_v<T>) return false;
  return parameter.structure != nullptr ? StructureOf<Target>() == parameter.structure
                                        : IsScalar<Target>(parameter.type);
}

template <typename Function>
struct Prototype;

template <typename... Args>
struct Prototype<short(Args...)> {
  using Arguments = std::tuple<Args...>;

  template <size_t size>
  static constexpr bool AgreesWith(const std::array<Parameter, size>& parameters) {
    if constexpr (sizeof...(Args) != size) {
      return false;
    } else {
      return [&]<size_t... i>(std::index_sequence<i...>) {
        return (Agrees<Args>(parameters[i]) && ...);
      }
      (std::index_sequence_for<Args...>());
    }
  }

  // `call` passes its arguments on to the command; this passes the first `count` arguments.
  template <typename Call, size_t count>
  static constexpr bool TakesFirst() {
    return []<size_t... i>(std::index_sequence<i...>) {
      return std::is_invocable_v<Call, std::tuple_element_t<i, Arguments>...>;
    }
    (std::make_index_sequence<count>());
  }
};

template <size_t size>
constexpr size_t RequiredCount(const std::array<Parameter, size>& parameters) {
  size_t count = 0;
  while (count < size && parameters[count].default_text.empty()) ++count;
  return count;
}

// All arguments from the first default on are optional, and no others.
template <typename Function, typename Call, size_t required>
constexpr bool MayBeLeftOut() {
  if constexpr (required > 0) {
    if (Prototype<Function>::template TakesFirst<Call, required - 1>()) return false;
  }
  return Prototype<Function>::template TakesFirst<Call, required>();
}

#define CHECK_kProgram(name)
#define CHECK_kBoth(name) CHECK_kHost(name)
#define CHECK_kLibrary(name) CHECK_kHost(name)
#define CHECK_kHost(name)                                                                          \
  static_assert(Prototype<decltype(::name)>::AgreesWith(rows::name), #name);                       \
  constexpr auto name##Call = [](auto... arguments) -> decltype(::name(arguments...)) {            \
    return ::name(arguments...);                                                                   \
  };                                                                                               \
  static_assert(MayBeLeftOut<decltype(::name), decltype(name##Call), RequiredCount(rows::name)>(), \
                #name);
#define COMMAND(number, name, tier, callers, ...) CHECK_##callers(name)
#include "gtcalls/gts/catalogue.def"

}  // namespace
}  // namespace oncard::gtcalls::gts
