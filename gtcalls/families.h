// The families of cards that this build has.
#pragma once

#include <span>

namespace oncard::gtcalls {

struct Family;

/// In the order of families.def; at least one. A test program can define a list of its own instead
/// of that in families.cc.
std::span<const Family* const> Families();

}  // namespace oncard::gtcalls
