// The catalogue of a family of cards: one row per command (catalogue.def of its folder), one per
// structure and constant of the interface (structures.def, constants.def). The compiler checks
// calls against it, the C header and the library's entry points are generated from it, the command
// documentation is printed from it, and the family's commands/ implement it. Read-only data, safe
// to use from any thread.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vm/command_table.h"

namespace oncard::gtcalls {

/// C type of a scalar parameter, or of a structure's member.
enum class Scalar : uint8_t {
  kChar,
  kUnsignedChar,
  kShort,
  kUnsignedShort,
  kInt,  ///< 32 bits on every host, unlike kLong
  kLong,
  kUnsignedLong,
  kDouble
};

/// How a parameter is passed.
enum class Passing : uint8_t {
  kValue,       ///< a scalar by value
  kInput,       ///< pointer: the command reads what it points to
  kOutput,      ///< pointer: the command writes what it points to
  kLent,        ///< pointer to working memory for the vendor's library: never accessed here
  kText,        ///< `char*`: a NUL-terminated name or file name, read only
  kTextOutput,  ///< `char**`: receives the address of a text that the library keeps
  kHandler,     ///< a function of the host, which the host library calls
  kHandle,      ///< names an object of the host's operating system
  kHostMemory,  ///< pointer to a structure of pointers to arrays of the host, which the command
                ///< fills
  kResult       ///< the last one: no parameter in C, but a function of the host that the command
                ///< returns in place of its code
};

/// Reliability of the interface row: A in the manuals or accepted by the vendor's compiler, B in
/// the basic public header, X thread extensions.
enum class Tier : uint8_t { kA, kB, kX };

/// The virtual time of a call from the host; in a motion program every command takes one statement.
enum class Cost : uint8_t {
  kHostCall,     ///< 50 us: a fifth of the card's rate (GTS manual 10.2)
  kMillisecond,  ///< 1 ms: GT_Update, GT_PtStart, GT_GearStart, GT_FollowStart (manual chapter 7)
  kMailbox,      ///< 4 ms: services of slaves on a bus (assumption)
  kNone          ///< no communication with the card: GT_Open, GT_Close, GT_Compile
};

/// The resources that a command can access; the explorer derives from them which statements are
/// independent.
enum class Resource : uint8_t {
  kNone = 0,
  kClock,          ///< the card's time
  kThread,         ///< the calling thread's own schedule (delay, page)
  kVariable,       ///< a program variable
  kProgram,        ///< downloaded program, bindings, thread states
  kDigitalInput,   ///< a DI word
  kDigitalOutput,  ///< a DO word
  kAnalog,         ///< ADC or DAC channel
  kExtension,      ///< an extension I/O module
  kAxis,           ///< an axis with its profile, status and limits
  kEncoder,        ///< an encoder or pulse counter
  kControl,        ///< a servo controller
  kCrd,            ///< a coordinate system with its FIFOs
  kCapture,        ///< capture and trigger units
  kCompare,        ///< position compare outputs
  kPvtTable,       ///< PVT tables
  kUserVariable,   ///< GT_SetLongVar and similar commands
  kConfiguration,  ///< card-wide settings
  kEverything      ///< may access the whole card
};

/// What a command accesses of a resource where that is less than Access::selector says. `detail` is
/// the parameter that says what. A command that stops axes or paths reaches the coordinate systems
/// to which the axes belong, and a coordinate system all its axes.
enum class Part : uint8_t {
  kWhole,
  kBit,            ///< of a word or module of outputs: the one with the number `detail`
  kBits,           ///< the digital outputs of a module
  kChannel,        ///< the analogue output `detail` of a module
  kNumbers,        ///< consecutive ones from the number `detail` on
  kEnableOutputs,  ///< the outputs that enable the axis `detail`
  kSelected,       ///< the axes, or coordinate systems, that the mask of axes `detail` selects
  kStopped,        ///< the same, and what a stop of them reaches
  kStoppedAxis,    ///< what a stop of the axis `detail` reaches
  kPathAxes        ///< the axes of the coordinate systems that the mask `detail` selects
};

/// An access: the resource that is read or written, and the parameter that selects which one (-1:
/// all).
struct Access {
  Resource resource = Resource::kNone;
  bool write = false;
  int selector = -1;  ///< index of the parameter holding the number, or a mask of them
  bool mask = false;  ///< the selector is a bit mask
  /// Index of the parameter with the number of consecutive resources, -1 for one.
  int count_parameter = -1;
  Part part = Part::kWhole;
  int detail = -1;        ///< index of the parameter that says which part
  int detail_count = -1;  ///< index of the parameter with the number of consecutive ones, -1: one
  int first = 0;          ///< kBit: the number of the first bit; kEnableOutputs: that of the word
};

struct Structure;
enum class Unit : uint8_t;

/// A member of an interface structure.
struct Member {
  std::string_view name;
  Scalar type = Scalar::kShort;
  int array_size = 0;                    ///< elements, 0 for a scalar
  bool pointer = false;                  ///< a pointer to `type`
  const Structure* structure = nullptr;  ///< a nested structure; `type` is then unused
  Unit unit{};                           ///< of members that motion programs write

  /// The same member while its row is written, with a unit.
  constexpr Member In(Unit new_unit) const {
    Member changed = *this;
    changed.unit = new_unit;
    return changed;
  }
};

/// A structure of the interface.
struct Structure {
  std::string_view name;
  std::span<const Member> members;
  /// May be declared in motion programs: TTrapPrm, TJogPrm, TPid.
  bool in_motion_program = false;
};

/// A constant of the interface.
struct Constant {
  std::string_view name;
  long value = 0;
};

/// Unit of a parameter or member, for documentation and messages.
enum class Unit : uint8_t {
  kNone,
  kPulse,
  kPulsePerMs,
  kPulsePerMs2,
  kPulsePerMs3,
  kPulsePerSt,  ///< of a card that counts motion in sample times
  kPulsePerSt2,
  kPulsePerSt3,
  kLengthUnit,  ///< of the coordinates of a path, as the host chooses it
  kLengthUnitPerSt,
  kLengthUnitPerSt2,
  kMillimetre,
  kMmPerS,
  kMmPerS2,
  kMillisecond,
  kMicrosecond,
  kCycle,      ///< profile cycles
  kQuarterMs,  ///< steps of 250 us
  kEighthMs,   ///< steps of 125 us
  kKilohertz,
  kVolt,
  kPercent,
  kCount,           ///< of a drive's encoder on a bus
  kCountPerSecond,  ///< the same
  kPerMille,        ///< of a drive's rated torque or current
  kByte,
  kIndex,  ///< the number of an axis, channel, buffer, thread, ...
  kMask,   ///< one bit per axis or coordinate system
  kBits    ///< one bit per input or output
};

/// One parameter.
struct Parameter {
  std::string_view name;
  Scalar type = Scalar::kShort;
  /// The name in the header of an enumeration that stands for the type, of a handler's type, or of
  /// the type of a pointer; empty: the type itself.
  std::string_view type_name;
  const Structure* structure = nullptr;  ///< pointer to a structure; `type` is then unused
  Passing passing = Passing::kValue;
  Unit unit = Unit::kNone;
  /// Range of a value (inclusive); checked before the command runs, code 7 outside. An open end is
  /// given as the nearest double inside the range.
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  /// The value of a C++ default argument as written in the header; empty = none.
  std::string_view default_text;
  /// Pointer: the index of the parameter with the number of elements, -1 for one element.
  int count_parameter = -1;
  /// Pointer to scalars without a count: their number.
  int array_size = 1;
  /// Pointer: NULL is allowed (mostly because it is the default).
  bool nullable = false;
  /// Output: also written when the command returns 1, to say why.
  bool on_refusal = false;
  /// Pointer without a count: one element per axis of the coordinate system that the first
  /// parameter names.
  bool per_dimension = false;
  /// The same: one element per capture offset of the encoder that the first parameter names.
  bool per_offset = false;
  /// The same: one element per axis of the card.
  bool per_axis = false;
  /// The number of an axis, profile, encoder, controller or output; a card may have fewer than
  /// `maximum`.
  bool axis_number = false;
  /// The same for an encoder: beyond those of the axes there are auxiliary ones.
  bool encoder_number = false;
  /// The number of consecutive ones, from the first parameter on.
  bool axis_count = false;

  /// True if a call in C has it as an argument.
  bool IsArgument() const { return passing != Passing::kResult; }
  /// True if the number of elements is up to the card.
  bool CountedByCard() const {
    return per_dimension || per_offset || per_axis || passing == Passing::kHostMemory;
  }
};

inline constexpr int kParameterMax = 13;

/// One command.
struct Command {
  uint16_t number = 0;  ///< in object files; never renumbered
  std::string_view name;
  Tier tier = Tier::kA;
  bool in_motion_program = false;
  /// Declared in gts.h and exported by the library; false for commands that act on the calling
  /// thread, such as GT_Delay.
  bool on_host = true;
  Cost cost = Cost::kHostCall;
  std::span<const Access> accesses;
  /// The return code follows from the arguments alone: no state of the card refuses the command.
  bool never_refused = false;
  std::span<const Parameter> parameters;
  std::string_view brief;     ///< what it does, one line
  std::string_view brief_zh;  ///< the same in Chinese
  std::string_view source;    ///< document and section that the row is based on

  /// True if it reads or writes a resource of this kind.
  bool Touches(Resource resource) const {
    return std::ranges::find(accesses, resource, &Access::resource) != accesses.end();
  }
};

/// A line of catalogue.def: the title of a topic, or a command.
struct Line {
  std::string_view topic;
  const Command* command = nullptr;  ///< nullptr for a topic
};

/// The tables of a catalogue (rows/tables.inc).
struct CatalogueTables {
  std::string_view name;                     ///< of the family, as in the names of its files: `gts`
  std::span<const Command> commands;         ///< by number, which counts from 1 without gaps
  std::span<const vm::CommandShape> shapes;  ///< the same commands for the virtual machine
  std::span<const Line> lines;               ///< in the order of documentation
  std::span<const Structure> structures;
  std::span<const Constant> constants;
};

/// The rows of one family. There is one object per family (gts/catalogue.h); the same name can mean
/// different things in two of them. Pointers and references that it returns are always valid.
class Catalogue {
 public:
  /// The tables must refer to constants of the program.
  explicit Catalogue(const CatalogueTables& tables);

  std::string_view name() const { return tables_.name; }

  /// All commands, in the order of their numbers.
  std::span<const Command> commands() const { return tables_.commands; }
  /// By name or number; nullptr if there is none.
  const Command* Find(std::string_view name) const;
  const Command* Find(uint16_t number) const {
    return number >= 1 && number <= tables_.commands.size() ? &tables_.commands[number - 1u]
                                                            : nullptr;
  }
  /// The command as the virtual machine sees it.
  const vm::CommandShape& ShapeOf(const Command& command) const {
    return tables_.shapes[command.number - 1u];
  }
  /// Topics with their commands, in the order of documentation.
  std::span<const Line> lines() const { return tables_.lines; }

  /// All structures and constants, in the order of the header.
  std::span<const Structure> structures() const { return tables_.structures; }
  const Structure* FindStructure(std::string_view name) const;
  std::span<const Constant> constants() const { return tables_.constants; }
  const Constant* FindConstant(std::string_view name) const;

 private:
  CatalogueTables tables_;
  std::vector<const Command*> by_name_;
};

/// The data type a motion program uses for a scalar: double for double, int for all others.
constexpr vm::DataType ProgramType(Scalar scalar) {
  return scalar == Scalar::kDouble ? vm::DataType::kDouble : vm::DataType::kInt;
}

/// Scalars of a structure, nested ones and array elements counted one by one. Text and pointers are
/// not counted: programs and commands never access them.
int CellCount(const Structure& structure);

/// The types of the arrays to which a structure's pointers refer, in the order of its members,
/// nested ones included.
std::vector<Scalar> ArraysOf(const Structure& structure);

/// The C spelling of a scalar type.
std::string_view SpellScalar(Scalar scalar);
/// The C declaration of a parameter without its default: `double *pValue`. `spell` gives the names
/// of scalar types.
std::string DeclareParameter(const Parameter& parameter,
                             std::string_view (*spell)(Scalar scalar) = SpellScalar);
/// The unit in words for documentation: `pulse/ms`; empty if there is none.
std::string_view SpellUnit(Unit unit);
/// The range for documentation and messages, `[1, 12]` or `(0, 32767]`; empty when unbounded.
std::string SpellRange(const Parameter& parameter);

}  // namespace oncard::gtcalls
