// toy.h: without a module, functions for several cards and other layouts, with an overload.
#include "gtcalls/interface_form.h"

#include "tests/families/toy/catalogue.h"

namespace oncard::gtcalls {
namespace {

constexpr std::string_view kHead =
    R"(/* Commands of the family that only the tests have. Generated: do not edit. */
#ifndef ONCARD_TOY_H_
#define ONCARD_TOY_H_

#ifdef __cplusplus
#define TOY_API_OF_(type) extern "C" __attribute__((visibility("default"))) type
#define TOY_DEFAULT_(value) = value
#else
#define TOY_API_OF_(type) __attribute__((visibility("default"))) type
#define TOY_DEFAULT_(value)
#endif
#define TOY_API TOY_API_OF_(short)

typedef void (*TOY_Handler)(int card);
typedef void (*TOY_Hearer)(const char* call, short code);
typedef void (*TOY_Isr)(void);
typedef void* TOY_Event;
typedef const void* TOY_Bytes;
)";

constexpr std::string_view kOverloads =
    R"(inline short TOY_Move(short axis, double velocity, double acceleration) {
  TToyMotion motion = {velocity, acceleration};
  return TOY_Move(axis, &motion);
}
)";

}  // namespace

const InterfaceForm& ToyInterfaceForm() {
  static const InterfaceForm kForm = {.catalogue = ToyCatalogue(),
                                      .catalogue_function = "ToyCatalogue",
                                      .catalogue_file = "tests/families/toy/catalogue.h",
                                      .header = "toy",
                                      .api = "TOY_API",
                                      .macro_prefix = "TOY_",
                                      .command_prefix = "TOY_",
                                      .head = kHead,
                                      .api_returning = "TOY_API_OF_",
                                      .overloads = kOverloads};
  return kForm;
}

}  // namespace oncard::gtcalls
