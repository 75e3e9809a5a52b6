// What goes over the line, against the schema of the session protocol.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "session/protocol_schema.h"
#include "tests/base/json_schema.h"

namespace oncard::session {

class ProtocolCheck {
 public:
  using Json = nlohmann::ordered_json;

  /// Fails the test unless all lines of an answer are what the schema says of the request, and the
  /// arguments of one that succeeds, too.
  void Expect(const Json& request, const std::string& answer) {
    std::istringstream lines(answer);
    std::string line;
    Json last;
    while (std::getline(lines, line)) {
      if (!last.is_null()) ExpectFit(last, Part("LogEvent"), request);
      last = Json::parse(line);
    }
    ExpectFit(last, Part("Answer"), request);
    if (!last.value("ok", false)) return;
    const Json& form = Form(request.at("request"));
    ExpectFit(request.value("arguments", Json::object()), form["arguments"], request);
    ExpectFit(last["result"], form["result"], request);
  }

  const Json& Part(const std::string& name) const { return schema_.root()["$defs"].at(name); }
  /// The `arguments` and the `result` of a request.
  const Json& Form(const std::string& request) const {
    return Part("Requests")["properties"].at(request)["properties"];
  }
  /// Members that no answer has had.
  std::set<std::string> UnusedMembers() const {
    std::set<std::string> unused;
    for (const auto& [name, _] : Part("Requests")["properties"].items()) {
      unused.merge(schema_.UnusedMembers(Form(name)["result"], name));
    }
    unused.merge(schema_.UnusedMembers(Part("Answer"), "Answer"));
    unused.merge(schema_.UnusedMembers(Part("LogEvent"), "LogEvent"));
    return unused;
  }

 private:
  void ExpectFit(const Json& value, const Json& form, const Json& request) {
    EXPECT_EQ(schema_.MistakeIn(value, form), "") << request;
  }

  JsonSchema schema_{Json::parse(ProtocolSchema())};
};

/// For all tests of a program: the schema is read once.
inline ProtocolCheck& TheProtocolCheck() {
  static ProtocolCheck check;
  return check;
}

}  // namespace oncard::session
