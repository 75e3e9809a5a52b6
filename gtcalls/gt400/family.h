// The family of GT400 cards.
#pragma once

#include "gtcalls/family.h"

namespace oncard::gtcalls {

const Family& Gt400Family();

}  // namespace oncard::gtcalls
