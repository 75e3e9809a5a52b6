// The catalogue of the family.
#pragma once

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

const Catalogue& ToyCatalogue();

}  // namespace oncard::gtcalls
