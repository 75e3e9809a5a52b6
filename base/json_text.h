// Writes JSON as text. All JSON output uses it, because names, comments and paths may be GBK or
// arbitrary bytes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/message.h"

namespace oncard {

/// The document in one line, or with each level indented by `indent` blanks when that is not
/// negative, without a newline at its end. Bytes that are not UTF-8 become U+FFFD.
std::string JsonText(const nlohmann::ordered_json& document, int indent = -1);

/// Messages for another process of oncard: a list of pairs of texts.
nlohmann::ordered_json JsonOfMessages(const std::vector<Message>& messages);
/// Adds those of such a list. False, with some of them added, if it is not one.
bool ReadMessages(const nlohmann::ordered_json& list, std::vector<Message>* messages);

}  // namespace oncard
