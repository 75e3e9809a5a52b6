// The catalogue of GTS controllers.
#pragma once

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

const Catalogue& GtsCatalogue();

}  // namespace oncard::gtcalls
