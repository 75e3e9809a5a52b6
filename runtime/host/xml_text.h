// What is done with the text of an XML file before the library parses it. The library parses nested
// elements by recursion, takes a NUL for the end of the text, and knows UTF-8 only. Tested by
// tests/runtime/xml_text_test.cc.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/message.h"

namespace oncard::runtime {

/// True if the text begins with the mark of UTF-16, in either order of bytes.
bool IsUtf16(std::string_view text);
/// UTF-8 of such a text. Characters beyond the first 65536 become U+FFFD.
std::string Utf8Of(std::string_view utf16);

struct XmlRefusal {
  size_t offset = 0;
  Message why;
};

/// Why a text is not given to the library: elements are nested too deep (kXmlDepthMax), or it
/// contains a NUL. Nothing else is checked.
std::optional<XmlRefusal> CheckXml(std::string_view text);

}  // namespace oncard::runtime
