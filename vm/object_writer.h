// Writes the vendor's object layout. Deterministic: the same Object gives the same bytes.
#pragma once

#include "vm/object.h"

namespace oncard::vm {

/// Turns an object into the contents of `X.bin` and `X.ini`. With `vendor_format` the `.ini` has
/// the vendor's sections only; otherwise a section `[oncard]` with the double format and the
/// `.bin`'s CRC-32 follows them. The object must be one that Verify() accepts.
ObjectFiles WriteObject(const Object& object, bool vendor_format);

}  // namespace oncard::vm
