// The form of the family of the tests, for a generator of its own.
#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

const InterfaceForm& ToyInterfaceForm();

std::span<const InterfaceForm* const> InterfaceForms() {
  static const InterfaceForm* const kForms[] = {&ToyInterfaceForm()};
  return kForms;
}

}  // namespace oncard::gtcalls
