#include "gtcalls/gts/interface_form.h"

#include <array>

#include "gtcalls/gts/catalogue.h"
#include "gtcalls/gts/rows.h"

namespace oncard::gtcalls {
namespace {

constexpr std::string_view kHead =
    R"(/* GT commands of GTS motion controllers, for C and C++. Generated: do not edit.

   Every command returns 0 when it is done, otherwise
      1   it cannot be executed in the present state
      7   a parameter is out of range, or NULL
      8   the command is not supported
     -1   no communication: the card is not open
     -6   the card cannot be opened
     -7   the card does not answer
   A refused command changes nothing. GT_Download, GT_GetFunId and GT_GetVarId also return 2007 (no
   such file or name) and 2008 (damaged file).

   Positions are in pulses, velocities in pulse/ms, accelerations in pulse/ms^2. In C++ the default
   arguments may be left out; in C every argument is written.

   GTS_MULTI_CARD, defined before this file is included, puts `short cardNum` (0 to 15) in front of
   every command's parameters; gts_multi.h does that. */
#ifndef ONCARD_GTS_H_
#define ONCARD_GTS_H_

#include <stddef.h>

#ifdef _WIN32
#define GTS_CALL_ __stdcall
#elif defined(__GNUC__)
#define GTS_CALL_ __attribute__((visibility("default")))
#else
#define GTS_CALL_
#endif

#ifdef __cplusplus
#define GT_API extern "C" short GTS_CALL_
#define GTS_DEFAULT_(value) = value
#else
#define GT_API short GTS_CALL_
#define GTS_DEFAULT_(value)
#endif

/* The error of TThreadSts from 100 on is a fault of the motion program, below it is the return code
   of the last command. */
#define GTS_FAULT_DIVISION_BY_ZERO 100
#define GTS_FAULT_INDEX_OUT_OF_BOUNDS 101
#define GTS_FAULT_OUTPUT_BEYOND_STORAGE 102
)";

/// The prototypes' names for one card: the other part of the switch between one card and several.
constexpr std::string_view kOneCard = R"(#define GTS_WIDE_(name)
#else
#define GTS_CARD_
#define GTS_CARD_ONLY_ void
/* Commands that take a structure which the vendor's basic gts.h lays out otherwise have a name of
   their own in the library; the plain name is for hosts that were compiled with that header. */
#ifdef __GNUC__
#define GTS_WIDE_(name) __asm__(#name)
#else
#error "gts.h needs a compiler that can name functions for the linker, as gcc and clang do"
#endif
#endif
)";

constexpr std::string_view kLookAheadHead =
    R"(/* Commands of the multi-axis look-ahead of GTS motion controllers, for C and C++. Generated: do
   not edit.

   In addition to the codes of gts.h:
    102   the first three coordinates are those of the command before
    103   GT_SetupLookAheadCrd has not been called
    104   GT_InitLookAheadEx has not been called, or has failed
    105   the library for five-axis machines is missing
    107   a parameter is out of range, an arc is not possible, or commands of both kinds are mixed
    110   the platform refuses: there is no such coordinate system, or it has fewer axes

   Positions are in mm, velocities in mm/s, accelerations in mm/s^2. */
#ifndef ONCARD_LOOK_AHEAD_EX_H_
#define ONCARD_LOOK_AHEAD_EX_H_

#include "gts.h"

#ifdef __cplusplus
#define GTS_DEFAULT_(value) = value
#else
#define GTS_DEFAULT_(value)
#endif

/* --- Constants --- */

#define LA_AXIS_NUM 8

#define AXIS_LIMIT_NONE 0
#define AXIS_LIMIT_MAX_VEL 1
#define AXIS_LIMIT_MAX_ACC 2
#define AXIS_LIMIT_MAX_DV 4

typedef enum EMachineMode {
  NORMAL_THREE_AXIS = 0,
  MULTI_AXES,
  FIVE_AXIS,
  FIVE_AXIS_WORK
} EMachineMode;

typedef enum EVelSettingDef { NORMAL_DEF_VEL = 0, NUM_DEF_VEL, CUT_DEF_VEL } EVelSettingDef;

typedef enum EWorkLimitMode { WORK_LIMIT_INVALID = 0, WORK_LIMIT_VALID } EWorkLimitMode;
)";

constexpr std::string_view kLookAheadStructures[] = {"TLookAheadParameter", "TPreStartPos"};

constexpr HeaderModule kLookAhead = {"LookAheadEx", "Multi-axis look-ahead", kLookAheadHead,
                                     kLookAheadStructures};

using namespace gts::structures;
using namespace words::members;

#define BASIC_LAYOUT(name, ...) constexpr std::array name##Basic = std::array{__VA_ARGS__};
#include "gtcalls/gts/basic_layouts.def"

constexpr Structure kBasicLayouts[] = {
#define BASIC_LAYOUT(name, ...) {#name, name##Basic, false},
#include "gtcalls/gts/basic_layouts.def"
};

constexpr TopicLine kTopics[] = {
#define COMMAND(...)
#define TOPIC(title) {title, {}},
#define NOTE(text) {{}, text},
#include "gtcalls/gts/catalogue.def"
};

}  // namespace

const InterfaceForm& GtsInterfaceForm() {
  static const InterfaceForm kForm = {.catalogue = GtsCatalogue(),
                                      .catalogue_function = "GtsCatalogue",
                                      .catalogue_file = "gtcalls/gts/catalogue.h",
                                      .header = "gts",
                                      .api = "GT_API",
                                      .macro_prefix = "GTS_",
                                      .command_prefix = "GT_",
                                      .head = kHead,
                                      .topics = kTopics,
                                      .multi_card_prefix = "GTM_",
                                      .one_card = kOneCard,
                                      .basic_layouts = kBasicLayouts,
                                      .wide_prefix = "GTX_",
                                      .module = &kLookAhead};
  return kForm;
}

}  // namespace oncard::gtcalls
