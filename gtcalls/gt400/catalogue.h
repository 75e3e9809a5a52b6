// The catalogue of GT400 cards.
#pragma once

#include "gtcalls/catalogue.h"

namespace oncard::gtcalls {

const Catalogue& Gt400Catalogue();

}  // namespace oncard::gtcalls
