// Writes the vendor's object layout. Deterministic: the same Object gives the same bytes.
#pragma once

#include <cstdint>
#include <string_view>

#include "vm/object.h"

namespace oncard::vm {

/// The version in section `[oncard]`, to be raised when the meaning of the files changes.
inline constexpr int kObjectFormat = 1;

/// Turns an object into the contents of `X.bin` and `X.ini`. With `vendor_format` the `.ini` has
/// the vendor's sections only; otherwise a section `[oncard]` with the double format and the
/// `.bin`'s CRC-32 follows them. The object must be one that Verify() accepts.
ObjectFiles WriteObject(const Object& object, bool vendor_format);

/// The CRC-32 of a whole `.bin`, as zlib computes it.
uint32_t BinChecksum(std::string_view bin);

/// How `[oncard]` and listings name a double format: `32.16` or `16.16`.
std::string_view DoubleFormatName(DoubleFormat format);

}  // namespace oncard::vm
