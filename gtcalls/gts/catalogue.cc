#include "gtcalls/gts/catalogue.h"

#include <algorithm>
#include <array>

#include "gtcalls/gts/rows.h"

namespace oncard::gtcalls {
namespace gts {
namespace {

#define FAMILY_COMMANDS "gtcalls/gts/catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/gts/structures.def"
#define FAMILY_CONSTANTS "gtcalls/gts/constants.def"
#include "gtcalls/rows/tables.inc"

}  // namespace
}  // namespace gts

const Catalogue& GtsCatalogue() {
  // Never destroyed: objects of a host may make calls while the process exits.
  static const Catalogue& catalogue =
      *new const Catalogue({"gts", gts::kCommands, gts::kShapes, gts::kLines,
                            gts::structures::Table::kRows, gts::kConstants});
  return catalogue;
}

}  // namespace oncard::gtcalls
