#include "gtcalls/gt400/catalogue.h"

#include <algorithm>
#include <array>
#include <span>

#include "gtcalls/gt400/rows.h"

namespace oncard::gtcalls {
namespace gt400 {
namespace {

#define FAMILY_COMMANDS "gtcalls/gt400/catalogue.def"
#define FAMILY_STRUCTURES "gtcalls/gt400/structures.def"
#define FAMILY_CONSTANTS "gtcalls/gt400/constants.def"
#include "gtcalls/rows/tables.inc"

}  // namespace
}  // namespace gt400

const Catalogue& Gt400Catalogue() {
  // Never destroyed: objects of a host may make calls while the process exits.
  static const Catalogue& catalogue = *new const Catalogue(
      {"gt400", gt400::kCommands, gt400::kShapes, gt400::kLines,
       std::span(gt400::structures::Table::kRows, gt400::structures::kCount), gt400::kConstants});
  return catalogue;
}

}  // namespace oncard::gtcalls
