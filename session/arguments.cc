#include "session/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/nearest.h"

namespace oncard::session {

Arguments::Arguments(const Json& json, std::string where) : json_(&json), where_(std::move(where)) {
  if (!json.is_object()) {
    Add(MakeMessage("{0}arguments must be an object", "{0}arguments 必须是对象", where_));
  }
}

void Arguments::Add(Message mistake) { mistakes_.push_back(std::move(mistake)); }

void Arguments::Expect(const std::string& name, const Message& expected) {
  const bool missing = !json_->is_object() || !json_->contains(name);
  Add(missing ? MakeMessage("'{0}{1}' is missing: {2}", "缺少“{0}{1}”：{3}", where_, name,
                            expected.en, expected.zh)
              : MakeMessage("'{0}{1}' is wrong: {2}", "“{0}{1}”有误：{3}", where_, name,
                            expected.en, expected.zh));
}

const Json* Arguments::Find(const std::string& name) {
  read_.insert(name);
  if (!json_->is_object()) return nullptr;
  const auto found = json_->find(name);
  return found == json_->end() ? nullptr : &*found;
}

bool Arguments::Has(const std::string& name) { return Find(name) != nullptr; }

std::string Arguments::Text(const std::string& name) {
  const Json* value = Find(name);
  if (value != nullptr && value->is_string()) return value->get<std::string>();
  Expect(name, {"a text", "应为文本"});
  return {};
}

bool Arguments::Flag(const std::string& name) {
  const Json* value = Find(name);
  if (value != nullptr && value->is_boolean()) return value->get<bool>();
  Expect(name, {"true or false", "应为 true 或 false"});
  return false;
}

double Arguments::Number(const std::string& name) {
  const Json* value = Find(name);
  if (value != nullptr && value->is_number()) return value->get<double>();
  Expect(name, {"a number", "应为数"});
  return 0;
}

double Arguments::Number(const std::string& name, double least, double largest) {
  const Json* value = Find(name);
  if (value != nullptr && value->is_number()) {
    const double number = value->get<double>();
    if (number >= least && number <= largest) return number;
  }
  Expect(name, MakeMessage("a number from {0} to {1}", "应为 {0} 至 {1} 的数", least, largest));
  return least;
}

int64_t Arguments::Whole(const std::string& name, int64_t least, int64_t largest) {
  const Json* value = Find(name);
  if (value != nullptr && value->is_number()) {
    const double number = value->get<double>();
    if (number == std::trunc(number) && number >= static_cast<double>(least) &&
        number <= static_cast<double>(largest)) {
      return static_cast<int64_t>(number);
    }
  }
  Expect(name, MakeMessage("an integer from {0} to {1}", "应为 {0} 至 {1} 的整数", least, largest));
  return 0;
}

std::vector<std::string> Arguments::Texts(const std::string& name) {
  std::vector<std::string> texts;
  const Json* value = Find(name);
  bool good = value != nullptr && value->is_array();
  for (size_t i = 0; good && i < value->size(); ++i) {
    good = (*value)[i].is_string();
    if (good) texts.push_back((*value)[i].get<std::string>());
  }
  if (!good) Expect(name, {"a list of texts", "应为文本列表"});
  return texts;
}

std::map<std::string, std::string> Arguments::TextsByName(const std::string& name) {
  std::map<std::string, std::string> texts;
  const Json* value = Find(name);
  if (value == nullptr) return texts;
  bool good = value->is_object();
  for (auto item = value->begin(); good && item != value->end(); ++item) {
    good = item->is_string();
    if (good) texts.emplace(item.key(), item->get<std::string>());
  }
  if (!good) Expect(name, {"an object with texts", "应为由文本组成的对象"});
  return texts;
}

size_t Arguments::Word(const std::string& name, const std::vector<std::string_view>& words) {
  const Json* value = Find(name);
  const std::string word =
      value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
  const auto found = std::ranges::find(words, std::string_view(word));
  if (found != words.end()) return static_cast<size_t>(found - words.begin());
  Expect(name,
         MakeMessage("one of {0}", "应为以下之一：{0}", fmt::to_string(fmt::join(words, ", "))));
  return 0;
}

std::vector<size_t> Arguments::Words(const std::string& name,
                                     const std::vector<std::string_view>& words) {
  std::vector<size_t> indices;
  for (const std::string& word : Texts(name, {})) {
    const auto found = std::ranges::find(words, std::string_view(word));
    if (found != words.end()) {
      indices.push_back(static_cast<size_t>(found - words.begin()));
    } else {
      Expect(name, MakeMessage("a list of {0}; there is no '{1}'", "应为列表，可含：{0}；没有“{1}”",
                               fmt::to_string(fmt::join(words, ", ")), word));
    }
  }
  return indices;
}

std::vector<Arguments> Arguments::Objects(const std::string& name) {
  std::vector<Arguments> objects;
  const Json* value = Find(name);
  if (value == nullptr) return objects;
  if (!value->is_array()) {
    Expect(name, {"a list of objects", "应为对象列表"});
    return objects;
  }
  for (size_t i = 0; i < value->size(); ++i) {
    objects.emplace_back((*value)[i], fmt::format("{}{}[{}].", where_, name, i));
  }
  return objects;
}

void Arguments::Join(Arguments part) {
  part.AddUnread();
  std::ranges::move(part.mistakes_, std::back_inserter(mistakes_));
}

std::string Arguments::Text(const std::string& name, std::string missing) {
  return Has(name) ? Text(name) : std::move(missing);
}

bool Arguments::Flag(const std::string& name, bool missing) {
  return Has(name) ? Flag(name) : missing;
}

int64_t Arguments::Whole(const std::string& name, int64_t least, int64_t largest, int64_t missing) {
  return Has(name) ? Whole(name, least, largest) : missing;
}

std::vector<std::string> Arguments::Texts(const std::string& name,
                                          std::vector<std::string> missing) {
  return Has(name) ? Texts(name) : std::move(missing);
}

void Arguments::AddUnread() {
  if (!json_->is_object()) return;
  const std::vector<std::string_view> known(read_.begin(), read_.end());
  for (auto item = json_->begin(); item != json_->end(); ++item) {
    if (read_.contains(item.key())) continue;
    const std::string_view near = NearestName(item.key(), known);
    Message mistake = MakeMessage("'{0}{1}' is not an argument of this request",
                                  "“{0}{1}”不是此请求的参数", where_, item.key());
    if (!near.empty()) {
      mistake.en += fmt::format("; did you mean '{}'?", near);
      mistake.zh += fmt::format("；是否为“{}”？", near);
    }
    Add(std::move(mistake));
  }
}

std::optional<Error> Arguments::Mistakes() {
  AddUnread();
  if (mistakes_.empty()) return std::nullopt;
  Message all;
  for (const Message& mistake : mistakes_) {
    all.en += (all.en.empty() ? "" : "\n") + mistake.en;
    all.zh += (all.zh.empty() ? "" : "\n") + mistake.zh;
  }
  return Error{1, std::move(all)};
}

}  // namespace oncard::session
