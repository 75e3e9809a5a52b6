// The types of C that structured programs use, and C's rules for them. On the card every value is
// an int of 32 bits or a fixed-point double; the narrower types and the unsigned ones exist only
// here. Tested by tests/lang/structured.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gtcalls/catalogue.h"
#include "vm/opcodes.h"

namespace oncard::compiler::lowering {

/// `long` is `int` and `float` is `double`, as on the card. In the order of conversion rank.
enum class BasicType : uint8_t {
  kVoid,
  kBool,
  kChar,
  kUnsignedChar,
  kShort,
  kUnsignedShort,
  kInt,
  kUnsigned,
  kDouble,
  kStructure
};

struct OwnStructure;

/// A type of C with its qualifiers.
struct Type {
  BasicType basic = BasicType::kInt;
  const OwnStructure* own = nullptr;  ///< of a structure
  bool is_const = false;
  /// The dimensions of a named array type, `typedef int row[4];`; nullptr for any other type. Only
  /// a declaration has it: what it declares has dimensions itself.
  const std::vector<int64_t>* rows = nullptr;
};

/// A member of a structure.
struct OwnMember {
  std::string_view name;
  Type type;
  std::vector<int64_t> dimensions;
  int leaf = 0;       ///< its first one among the leaves of the structure
  int64_t begin = 0;  ///< its first value among those of the structure
};

/// What a structure has a variable of the card for: a number or an array of numbers.
struct Leaf {
  std::string name;     ///< `m`, or `inner_m` of a structure in it
  std::string written;  ///< `.m`, or `.inner[2].m[4]`
  Type type;
  /// Of a member of a structure of the card: this structure, which has the names, and which member.
  const gtcalls::Structure* card = nullptr;
  int16_t member = 0;
  bool is_array = false;
  int64_t size = 1;  ///< values of an array; several dimensions are one
};

/// A structure that the program defines, or one of the card.
struct OwnStructure {
  std::string_view name;  ///< `struct Name`
  const gtcalls::Structure* card = nullptr;
  bool complete = false;  ///< the members are known
  bool invalid = false;   ///< there was an error, and some members may be missing
  std::vector<OwnMember> members;
  std::vector<Leaf> leaves;
  int64_t values = 0;  ///< numbers in it
  int64_t bytes = 0;
  int64_t alignment = 1;
};

constexpr bool IsInteger(BasicType type) {
  return type >= BasicType::kBool && type <= BasicType::kUnsigned;
}
constexpr bool IsArithmetic(BasicType type) {
  return type >= BasicType::kBool && type <= BasicType::kDouble;
}

/// The type of the card that holds the values.
constexpr vm::DataType DataTypeOf(BasicType type) {
  if (type == BasicType::kVoid) return vm::DataType::kVoid;
  return type == BasicType::kDouble ? vm::DataType::kDouble : vm::DataType::kInt;
}

/// The integer promotions.
constexpr BasicType Promoted(BasicType type) {
  return type < BasicType::kInt ? BasicType::kInt : type;
}

/// The usual arithmetic conversions of two operands.
constexpr BasicType Common(BasicType a, BasicType b) {
  const BasicType left = Promoted(a);
  const BasicType right = Promoted(b);
  return left > right ? left : right;
}

/// True when every value of the first type is one of the second, bit by bit.
bool Fits(BasicType values, BasicType into);

/// Bytes, as `sizeof` gives them on the controllers' compilers.
int SizeOf(BasicType type);

/// The value of an integer, converted to another integer type.
int64_t ConvertInteger(int64_t value, BasicType type);

/// As C spells it.
std::string_view NameOf(BasicType type);

/// The name of a part of what has a name, `axis_target`; the part may have none.
std::string JoinNames(std::string_view whole, std::string_view part);

/// The sizes of an array as they are declared: `[2][3]`.
std::string SpellSizes(const std::vector<int64_t>& dimensions);

}  // namespace oncard::compiler::lowering
