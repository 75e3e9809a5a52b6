// Tests that put requests to a host of the session protocol. Every answer is compared with the
// schema.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "session/host.h"
#include "tests/session/protocol_check.h"

namespace oncard::session {

class AskingTest : public testing::Test {
 protected:
  using Json = nlohmann::ordered_json;

  explicit AskingTest(SessionHost host = SessionHost()) : host_(std::move(host)) {}

  /// The last line of the answer.
  Json Ask(const std::string& request, Json arguments = Json::object()) {
    const Json message = {{"id", ++id_}, {"request", request}, {"arguments", std::move(arguments)}};
    const std::string answer = host_.Handle(message.dump());
    EXPECT_EQ(answer.back(), '\n');
    TheProtocolCheck().Expect(message, answer);
    const size_t last = answer.find_last_of('\n', answer.size() - 2);
    const size_t begin = last == std::string::npos ? 0 : last + 1;
    events_ = answer.substr(0, begin);
    const Json response = Json::parse(answer.substr(begin));
    EXPECT_EQ(response["id"], id_);
    return response;
  }
  /// The result of a request that must succeed.
  Json Result(const std::string& request, Json arguments = Json::object()) {
    const Json response = Ask(request, std::move(arguments));
    EXPECT_TRUE(response["ok"]) << response;
    return response["result"];
  }
  /// The error of one that must fail.
  std::string ErrorOf(const std::string& request, Json arguments = Json::object()) {
    const Json response = Ask(request, std::move(arguments));
    EXPECT_FALSE(response["ok"]) << response;
    return response.value("error", "");
  }

  SessionHost host_;
  /// The lines of the last answer before its last one.
  std::string events_;
  int id_ = 0;
};

}  // namespace oncard::session
