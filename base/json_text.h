// Writes JSON as text. All JSON output uses it, because names, comments and paths may be GBK or
// arbitrary bytes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace oncard {

/// The document in one line, or with each level indented by `indent` blanks when that is not
/// negative, without a newline at its end. Bytes that are not UTF-8 become U+FFFD.
std::string JsonText(const nlohmann::ordered_json& document, int indent = -1);

}  // namespace oncard
