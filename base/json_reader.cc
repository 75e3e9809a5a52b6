#include "base/json_reader.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace oncard {
namespace {

using Json = nlohmann::ordered_json;

/// Every key of an object takes at least as much: `"":0` and a comma or brace.
constexpr size_t kKeyBytesMin = 5;

/// Counts the keys of each object without keeping anything; ends at the first one too many.
class KeyCount : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(int64_t /*value*/) override { return true; }
  bool number_unsigned(uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(Json::binary_t& /*value*/) override { return true; }
  bool start_object(size_t /*size*/) override {
    keys_.push_back(0);
    return true;
  }
  bool key(std::string& /*name*/) override { return ++keys_.back() <= kJsonKeysMax; }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool start_array(size_t /*size*/) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(size_t /*place*/, const std::string& /*token*/,
                   const Json::exception& /*error*/) override {
    return false;
  }

 private:
  std::vector<size_t> keys_;  ///< of the objects that are open
};

}  // namespace

Json ReadJson(std::string_view text) {
  KeyCount count;
  const bool counts = text.size() > kKeyBytesMin * kJsonKeysMax;
  if (counts && !Json::sax_parse(text, &count)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

}  // namespace oncard
