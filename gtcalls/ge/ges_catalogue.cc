#include "gtcalls/ge/ges_catalogue.h"

#include <algorithm>
#include <array>

#include "gtcalls/ge/ges_rows.h"

namespace oncard::gtcalls {
namespace ges {
namespace {

#define FAMILY_COMMANDS "gtcalls/ge/ges_catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/ge/ges_structures.def"
#define FAMILY_CONSTANTS "gtcalls/ge/ges_constants.def"
#include "gtcalls/rows/tables.inc"

}  // namespace
}  // namespace ges

const Catalogue& GesCatalogue() {
  // Never destroyed: objects of a host may make calls while the process exits.
  static const Catalogue& catalogue =
      *new const Catalogue({"ges", ges::kCommands, ges::kShapes, ges::kLines,
                            ges::structures::Table::kRows, ges::kConstants});
  return catalogue;
}

}  // namespace oncard::gtcalls
