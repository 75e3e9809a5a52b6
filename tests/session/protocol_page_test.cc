// docs/session-protocol.md lists every request with its arguments.
#include <gtest/gtest.h>

#include <regex>

#include "base/files.h"
#include "base/limits.h"
#include "session/host.h"

namespace oncard::session {
namespace {

TEST(ProtocolPage, ListsTheRequestsWithTheirArguments) {
  const auto page =
      ReadFile(std::string(ONCARD_SOURCE_DIR) + "/docs/session-protocol.md", kSourceKind);
  ASSERT_TRUE(page.ok());
  static const std::regex kWord(R"((\[?[a-z_]+\]?))");
  std::string rows;
  for (const RequestText& request : SessionHost::RequestTexts()) {
    const std::string arguments = std::regex_replace(std::string(request.arguments), kWord, "`$1`");
    rows =
        "| `" + std::string(request.name) + "` | " + arguments + (arguments.empty() ? "| " : " | ");
    EXPECT_NE(page.value().find("\n" + rows), std::string::npos) << rows;
  }
}

}  // namespace
}  // namespace oncard::session
