// Tested by tests/base/json_text_test.cc.
#include "base/json_text.h"

#include <nlohmann/json.hpp>

namespace oncard {

std::string JsonText(const nlohmann::ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::ordered_json JsonOfMessages(const std::vector<Message>& messages) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Message& message : messages) list.push_back({message.en, message.zh});
  return list;
}

bool ReadMessages(const nlohmann::ordered_json& list, std::vector<Message>* messages) {
  if (!list.is_array()) return false;
  for (const nlohmann::ordered_json& message : list) {
    if (!message.is_array() || message.size() != 2 || !message[0].is_string() ||
        !message[1].is_string()) {
      return false;
    }
    messages->push_back({message[0], message[1]});
  }
  return true;
}

}  // namespace oncard
