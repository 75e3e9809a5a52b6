// ges.h, for hosts of GE cards for paths.
#include "gtcalls/ge/ges_catalogue.h"
#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {
namespace ges {
namespace {

constexpr std::string_view kHead =
    R"(/* Commands of GE motion controllers for paths (GE-X00-SX), for C and C++.
   Generated: do not edit.

   Every command returns 0 when it is done, otherwise
      1   it cannot be executed in the present state; GT_GetCmdSts says why
      2   the radius or the chord of an arc is 0
      3   a line has no length
      4   a velocity or an acceleration is out of range, or not set
      5   the chord of an arc is longer than its diameter
      7   a parameter is out of range, or NULL
      9   GT_M30: not yet, call it again
     -1   no communication: the card is not open, or cannot be opened
   A refused command changes nothing. GT_GetCurrentCardNo returns the number of the card.

   Positions are in pulses, velocities in pulse/ms, accelerations in pulse/ms^2; commands with
   Ex take mm, mm/s and mm/s^2. In C++ the default argument may be left out; in C it is written. */
#ifndef ONCARD_GES_H_
#define ONCARD_GES_H_

#if !defined(_WIN32) && !defined(__stdcall)
#define __stdcall
#endif

#ifdef __GNUC__
#define GE_CALL_ __attribute__((visibility("default")))
#else
#define GE_CALL_ __stdcall
#endif

#ifdef __cplusplus
#define GT_API extern "C" short GE_CALL_
#define GE_DEFAULT_(value) = value
#else
#define GT_API short GE_CALL_
#define GE_DEFAULT_(value)
#endif

/* Told of every command: its text, and what it returned. Both names are in use. */
typedef void(__stdcall *TCommandHandle)(char *command, short error);
typedef TCommandHandle CCommandHandle;
)";

/// What the manual writes otherwise than the public header, which hosts have been compiled with.
constexpr std::string_view kOverloads =
    R"(inline short GT_GetSts(unsigned short axis, unsigned long* status) {
  unsigned short word = 0;
  const short code = GT_GetSts(axis, &word);
  if (code == 0) *status = word;
  return code;
}
inline short GT_InitLookAheadExx(double T, double amax, double am, short n, double con, double,
                                 char*) {
  return GT_InitLookAheadExx(T, amax, am, n, con);
}
)";

constexpr TopicLine kTopics[] = {
#define COMMAND(...)
#define TOPIC(title) {title, {}},
#include "gtcalls/ge/ges_catalogue.def"
};

}  // namespace
}  // namespace ges

const InterfaceForm& GesInterfaceForm() {
  static const InterfaceForm kForm = {.catalogue = GesCatalogue(),
                                      .catalogue_function = "GesCatalogue",
                                      .catalogue_file = "gtcalls/ge/ges_catalogue.h",
                                      .header = "ges",
                                      .api = "GT_API",
                                      .macro_prefix = "GE_",
                                      .command_prefix = "GT_",
                                      .head = ges::kHead,
                                      .topics = ges::kTopics,
                                      .overloads = ges::kOverloads};
  return kForm;
}

}  // namespace oncard::gtcalls
