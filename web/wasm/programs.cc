// The module for programs, which pages load first: it knows the families of cards with motion
// programs, reads no records of hosts and searches no interleavings.
#include "gtcalls/families.h"
#include "gtcalls/gts/family.h"
#include "web/wasm/module_parts.h"

namespace oncard {

std::span<const gtcalls::Family* const> gtcalls::Families() {
  static const Family* const kFamilies[] = {&GtsFamily()};
  return kFamilies;
}

session::CallReader web::RecordReader() { return nullptr; }

web::Explorer web::ExplorerOfModule() { return nullptr; }

}  // namespace oncard
