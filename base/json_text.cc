// Tested by tests/base/json_text_test.cc.
#include "base/json_text.h"

#include <nlohmann/json.hpp>

namespace oncard {

std::string JsonText(const nlohmann::ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace oncard
