// The words in which the session protocol is described (protocol_parts.h): types, and objects with
// their members, each as a JSON Schema. An object has no members but those that are described.
#pragma once

#include <concepts>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace oncard::session::schema {

using Json = nlohmann::ordered_json;

// --- Types ---------------------------------------------------------------------------------------

Json Text();
Json Flag();
Json Whole();
Json Number();
Json Anything();
/// This value and no other.
Json Always(Json value);
/// One of these texts.
Json Words(const std::vector<std::string_view>& words);
Json ListOf(Json item);
/// An object whose members have any names, and this type.
Json ByName(Json member);
Json OneOf(std::vector<Json> types);
Json OrNull(Json type);
/// The type of a part, by its name.
Json The(std::string_view part);

/// What `name` says of the values of an enumeration, from the first to the last.
template <typename Enum, std::invocable<Enum> Name>
std::vector<std::string_view> Names(Enum first, Enum last, const Name& name) {
  using Number = std::underlying_type_t<Enum>;
  std::vector<std::string_view> names;
  for (int value = static_cast<Number>(first); value <= static_cast<Number>(last); ++value) {
    names.push_back(name(static_cast<Enum>(value)));
  }
  return names;
}

// --- Objects -------------------------------------------------------------------------------------

struct Member {
  std::string name;
  Json type;
  bool required = true;
};
using Members = std::vector<Member>;

/// A member that an object always has.
Member Has(std::string_view name, Json type, std::string_view meaning = {});
/// One that it can lack.
Member MayHave(std::string_view name, Json type, std::string_view meaning = {});

Members operator+(Members members, const Members& more);

Json Object(const Members& members);

/// What has a name of its own, because several others have it or clients speak of it.
struct Part {
  std::string_view name;
  std::string_view meaning;
  Json type;
};

}  // namespace oncard::session::schema
