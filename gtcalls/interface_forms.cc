#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

#define FAMILY(name, Name) const InterfaceForm& Name##InterfaceForm();
#include "gtcalls/families.def"

std::span<const InterfaceForm* const> InterfaceForms() {
  static const InterfaceForm* const kForms[] = {
#define FAMILY(name, Name) &Name##InterfaceForm(),
#include "gtcalls/families.def"
  };
  return kForms;
}

}  // namespace oncard::gtcalls
