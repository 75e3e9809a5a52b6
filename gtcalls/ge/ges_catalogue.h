// The catalogue of GE cards for paths.
#pragma once

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

const Catalogue& GesCatalogue();

}  // namespace oncard::gtcalls
