#include "gtcalls/ge/gep_catalogue.h"

#include <algorithm>
#include <array>

#include "gtcalls/ge/gep_rows.h"

namespace oncard::gtcalls {
namespace gep {
namespace {

#define FAMILY_COMMANDS "gtcalls/ge/gep_catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/ge/structures.def"
#define FAMILY_CONSTANTS "gtcalls/ge/gep_constants.def"
#include "gtcalls/rows/tables.inc"

}  // namespace
}  // namespace gep

const Catalogue& GepCatalogue() {
  // Never destroyed: objects of a host may make calls while the process exits.
  static const Catalogue& catalogue =
      *new const Catalogue({"gep", gep::kCommands, gep::kShapes, gep::kLines,
                            gep::structures::Table::kRows, gep::kConstants});
  return catalogue;
}

}  // namespace oncard::gtcalls
