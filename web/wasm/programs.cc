// The module for programs, which pages load first: it knows the families of cards with motion
// programs, and reads no records of hosts.
#include "gtcalls/families.h"
#include "gtcalls/gts/family.h"
#include "web/wasm/record_reader.h"

namespace oncard {

std::span<const gtcalls::Family* const> gtcalls::Families() {
  static const Family* const kFamilies[] = {&GtsFamily()};
  return kFamilies;
}

session::CallReader web::RecordReader() { return nullptr; }

}  // namespace oncard
