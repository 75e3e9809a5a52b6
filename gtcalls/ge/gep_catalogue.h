// The catalogue of GE cards for point-to-point motion.
#pragma once

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

const Catalogue& GepCatalogue();

}  // namespace oncard::gtcalls
