// Reads the vendor's object layout, from any compiler and possibly damaged: every length is checked
// before it is used, and nothing read is trusted before Verify() has accepted it.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.h"
#include "vm/object.h"

namespace oncard::vm {

/// Longest path that ReadObjectPair() takes, in bytes. Assumption: the manual refuses names that
/// are "too long" without a figure for programs, and gives this one for configuration files.
inline constexpr size_t kObjectPathMax = 125;

/// Decodes the contents of a pair. Fails with code 2008 when a file is damaged, when the two do not
/// belong together, or when the checksum in `[oncard]` differs; with 7 when there are more than 32
/// functions. An `.ini` without `[oncard]` is a vendor's: 32.16, no checksum. Verify() checks the
/// meaning of names, ids and instructions.
Result<Object> ReadObject(const ObjectFiles& files);

/// Reads `X.bin` and the `X.ini` beside it. Code 2007: no such `.bin`, a name too long, or one that
/// does not end in `.bin`; 2008: no `.ini`, unreadable, or as ReadObject(); 7 as ReadObject().
/// `content` receives the bytes of both files if they could be read.
Result<Object> ReadObjectPair(const std::string& bin_path, ObjectFiles* content = nullptr);

/// The `.ini` that goes with a `.bin`: the same path with the ending exchanged.
std::string IniPathFor(const std::string& bin_path);

}  // namespace oncard::vm
