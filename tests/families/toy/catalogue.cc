#include "tests/families/toy/catalogue.h"

#include <algorithm>
#include <array>

#include "tests/families/toy/rows.h"

namespace oncard::gtcalls {
namespace toy {
namespace {

#define FAMILY_COMMANDS "tests/families/toy/catalogue.def"
#define FAMILY_STRUCTURES "tests/families/toy/structures.def"
#define FAMILY_CONSTANTS "tests/families/toy/constants.def"
#include "gtcalls/rows/tables.inc"

}  // namespace
}  // namespace toy

const Catalogue& ToyCatalogue() {
  static const Catalogue& catalogue =
      *new const Catalogue({"toy", toy::kCommands, toy::kShapes, toy::kLines,
                            toy::structures::Table::kRows, toy::kConstants});
  return catalogue;
}

}  // namespace oncard::gtcalls
