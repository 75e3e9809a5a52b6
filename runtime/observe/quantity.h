// Names of the observable values of a card: the same names are used for the results of tools, the
// expectations of scenarios and the columns of traces.
//
//   sum  a[3]  trap.acc             global variables
//   axis[2].target  m[1][2]         those of structured C (vm/symbol_names.h)
//   page1.i  page1.a[2]             local variables on a data page
//   thread0.result  thread0.run     the values of GT_GetThreadSts: run, result, error, line;
//                                   and page, statements
//   axis1.prfPos  profile1.vel      what the motion core computes (motion_values.h)
//   gpo  gpo[1]                     a digital output or input word, or one bit of it, numbered from
//                                   1 as GT_SetDoBit does: enable clear gpo limit_positive
//                                   limit_negative alarm home gpi arrive mpg
//   clock  statements               milliseconds since GT_Reset; statements since the download
//
// A global variable hides a word or `clock` of the same name, and a structure all names that begin
// with its name and a dot.
// Tested by tests/runtime/scenario_names_test.cc.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "runtime/observe/motion_values.h"
#include "runtime/sim/axis_unit.h"
#include "runtime/sim/controller.h"

namespace oncard::runtime {

enum class QuantityKind : uint8_t {
  kVariable,
  kThreadRun,
  kThreadResult,
  kThreadError,
  kThreadLine,
  kThreadPage,
  kThreadStatements,
  kInputWord,
  kInputBit,
  kOutputWord,
  kOutputBit,
  kMotion,
  kClock,
  kStatements,
};

/// One observable number. A plain value, valid for controllers with the same program.
struct Quantity {
  std::string name;
  QuantityKind kind = QuantityKind::kClock;
  vm::SlotAddress slot;                ///< kVariable
  bool is_part = false;                ///< kVariable: what was asked for is an array or a structure
  int thread = 0;                      ///< kThread...
  int word = 0;                        ///< number of the input or output word
  int bit = 0;                         ///< from 0
  const MotionPart* part = nullptr;    ///< kMotion
  const MotionValue* value = nullptr;  ///< kMotion: of that part
  size_t index = 0;                    ///< of the part, from 0
  AxisUnit axis_unit = {};             ///< of what is measured along an axis that has a unit

  Unit unit() const { return value == nullptr ? Unit::kNone : value->unit; }
  /// What is measured along the axis; only with a unit.
  AxisMeasure measure() const {
    return unit() == Unit::kPulse        ? AxisMeasure::kPosition
           : unit() == Unit::kPulsePerMs ? AxisMeasure::kVelocity
                                         : AxisMeasure::kAcceleration;
  }
  /// The unit as text, as UnitName() gives it or that of the axis: "mm/s".
  std::string UnitText(bool per_cycle) const {
    return axis_unit.named() ? axis_unit.NameOf(measure())
                             : std::string(UnitName(unit(), per_cycle));
  }
  /// The name with the unit of the axis, if it has one: "axis1.prfPos [mm]".
  std::string Title() const {
    return axis_unit.named() ? name + " [" + axis_unit.NameOf(measure()) + "]" : name;
  }
  /// A value in pulses and milliseconds, as it is shown.
  double Shown(double of_card) const { return axis_unit.FromPulses(of_card, measure()); }
};

/// Resolves a name for the controller's program and its bindings: a local belongs to the function
/// bound to the page or, if no thread is bound to it, to the only bound function that has such a
/// variable. The name of an array or a structure refers to all its elements. A variable of
/// structured C is called as there, however it was asked for. Fails for an unknown name and
/// suggests a similar one.
Result<std::vector<Quantity>> ResolveQuantity(std::string_view name, const Controller& controller);

/// A name as the function of a thread means it: `page3.i` for its local variable `i` on page 3,
/// which hides a global; any other name unchanged.
std::string NameInThread(std::string_view name, int thread, const Controller& controller);

/// True for what only a program has: its variables and its threads.
bool IsOfProgram(QuantityKind kind);

/// All global variables, in the order of their declaration, an element of an array of structures
/// after the other.
std::vector<Quantity> GlobalQuantities(const Controller& controller);
/// The same for the local variables of a function on a page.
std::vector<Quantity> LocalQuantities(int function, int page, const Controller& controller);

/// The value now. Every int and every fixed-point number is exact as a double.
double ReadQuantity(const Quantity& quantity, const Controller& controller);

/// How the current value is printed; a thread's result has the return type of its function.
NumberForm FormOfQuantity(const Quantity& quantity, const Controller& controller);

/// How values of a type of the language are printed.
NumberForm FormOf(vm::DataType type);

/// A value as text: `5050`, `12.5`, `3.0`, with the shortest digits that represent it exactly.
std::string FormatNumber(double value, NumberForm form);
/// The same at the end of a text.
void AppendNumber(double value, NumberForm form, std::string* text);

/// Names of all input and output words.
std::span<const std::string_view> WordNames();
/// The input word of a name above; empty for another name.
std::optional<motion::DiType> FindInputWord(std::string_view name);
/// How many bits, and so pins, the word of a name above has; 0 for another name.
int WordWidth(std::string_view name);
/// The name of an input word.
std::string_view InputWordName(motion::DiType type);

}  // namespace oncard::runtime
