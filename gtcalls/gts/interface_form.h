// gts.h and the entry points of libgts.
#pragma once

#include "gtcalls/interface_form.h"

namespace oncard::gtcalls {

const InterfaceForm& GtsInterfaceForm();

}  // namespace oncard::gtcalls
