// gep.h, for hosts of GE cards for point-to-point motion.
#include "gtcalls/ge/gep_catalogue.h"
#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {
namespace gep {
namespace {

constexpr std::string_view kHead =
    R"(/* Commands of GE motion controllers for point-to-point motion (GE-X00-PX), for C and C++.
   Generated: do not edit.

   Every command returns 0 when it is done, otherwise
      1   it cannot be executed in the present state; GT_GetCmdSts says why
      7   a parameter is out of range, or NULL
     -1   no communication: the card is not open, or cannot be opened
   A refused command changes nothing. GT_GetCurrentCardNo returns the number of the card.

   Positions are in pulses, velocities in pulse/ms, accelerations in pulse/ms^2, jerks in
   pulse/ms^3. In C++ the default argument may be left out; in C it is written. */
#ifndef ONCARD_GEP_H_
#define ONCARD_GEP_H_

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

constexpr TopicLine kTopics[] = {
#define COMMAND(...)
#define TOPIC(title) {title, {}},
#include "gtcalls/ge/gep_catalogue.def"
};

}  // namespace
}  // namespace gep

const InterfaceForm& GepInterfaceForm() {
  static const InterfaceForm kForm = {.catalogue = GepCatalogue(),
                                      .catalogue_function = "GepCatalogue",
                                      .catalogue_file = "gtcalls/ge/gep_catalogue.h",
                                      .header = "gep",
                                      .api = "GT_API",
                                      .macro_prefix = "GE_",
                                      .command_prefix = "GT_",
                                      .head = gep::kHead,
                                      .topics = gep::kTopics};
  return kForm;
}

}  // namespace oncard::gtcalls
