// The arguments of a request of the session protocol: members of a JSON object, each read with its
// type. Mistakes are collected, so that a client sees all of them at once; members that nothing has
// read are mistakes, too. Tested by tests/session/host_test.cc.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace oncard::session {

using Json = nlohmann::ordered_json;

class Arguments {
 public:
  /// `json` must outlive the arguments; `where` names it in messages: empty, or `lines[2].`.
  explicit Arguments(const Json& json, std::string where = {});

  /// True if there is a member with this name.
  bool Has(const std::string& name);

  // A missing member or one with another type is a mistake; the result is then empty or 0.

  std::string Text(const std::string& name);
  bool Flag(const std::string& name);
  double Number(const std::string& name);
  double Number(const std::string& name, double least, double largest);
  int64_t Whole(const std::string& name, int64_t least, int64_t largest);
  std::vector<std::string> Texts(const std::string& name);
  /// One of the words; the result is its index.
  size_t Word(const std::string& name, const std::vector<std::string_view>& words);

  // The same with a value for a missing member.

  std::string Text(const std::string& name, std::string missing);
  bool Flag(const std::string& name, bool missing);
  int64_t Whole(const std::string& name, int64_t least, int64_t largest, int64_t missing);
  std::vector<std::string> Texts(const std::string& name, std::vector<std::string> missing);

  // Empty for a missing member.

  /// A list of these words; the result is their indices.
  std::vector<size_t> Words(const std::string& name, const std::vector<std::string_view>& words);
  std::map<std::string, std::string> TextsByName(const std::string& name);
  /// The objects in a list, each with its arguments. Join() is to be called with each when all its
  /// members have been read: it adds its mistakes.
  std::vector<Arguments> Objects(const std::string& name);
  void Join(Arguments part);

  /// Everything that was wrong. To be called once, after all members have been read.
  std::optional<Error> Mistakes();

 private:
  const Json* Find(const std::string& name);
  /// Adds a mistake: what was expected of a member.
  void Expect(const std::string& name, const Message& expected);
  void Add(Message mistake);
  /// Adds the members that have not been read.
  void AddUnread();

  const Json* json_;
  std::string where_;
  std::set<std::string> read_;
  std::vector<Message> mistakes_;
};

}  // namespace oncard::session
