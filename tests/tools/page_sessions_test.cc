#include "tools/page_sessions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace oncard::tools {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr PageSessions::Time kStart{};

session::SessionHost WithoutFiles() {
  return session::SessionHost([](const std::string& path) -> Result<std::string> {
    return MakeError(1, "there is no '{0}'", "没有“{0}”", path);
  });
}

// As many sessions as there may be, each opened a second after the one before.
std::vector<uint64_t> OpenAll(PageSessions* sessions) {
  std::vector<uint64_t> numbers;
  for (size_t i = 0; i < kSessionsMax; ++i) {
    numbers.push_back(sessions->Open(kStart + seconds(i)).value());
  }
  return numbers;
}

TEST(PageSessionsTest, ANewOneTakesThePlaceOfTheOneUnusedLongest) {
  PageSessions sessions(WithoutFiles);
  const std::vector<uint64_t> numbers = OpenAll(&sessions);
  sessions.Use(numbers[0], kStart + minutes(5));
  const std::shared_ptr<PageSession> unused = sessions.Use(numbers[1], kStart + seconds(1));
  EXPECT_TRUE(sessions.Open(kStart + seconds(1) + kUnusedTime));
  EXPECT_TRUE(unused->closed);
  EXPECT_EQ(sessions.Use(numbers[1], kStart + minutes(11)), nullptr);
  EXPECT_NE(sessions.Use(numbers[0], kStart + minutes(11)), nullptr);
  EXPECT_NE(sessions.Use(numbers[2], kStart + minutes(11)), nullptr);
}

TEST(PageSessionsTest, SessionsInUseAreKept) {
  PageSessions sessions(WithoutFiles);
  const std::vector<uint64_t> numbers = OpenAll(&sessions);
  EXPECT_FALSE(sessions.Open(kStart + kUnusedTime - seconds(1)));
  for (const uint64_t number : numbers) sessions.Use(number, kStart + minutes(60));
  EXPECT_FALSE(sessions.Open(kStart + minutes(69)));
  EXPECT_TRUE(sessions.Close(numbers[3]));
  EXPECT_TRUE(sessions.Open(kStart + minutes(69)));
}

TEST(PageSessionsTest, UnusedOnesStayAsLongAsThereIsPlace) {
  PageSessions sessions(WithoutFiles);
  const uint64_t number = sessions.Open(kStart).value();
  EXPECT_TRUE(sessions.Open(kStart + minutes(600)));
  EXPECT_NE(sessions.Use(number, kStart + minutes(600)), nullptr);
}

}  // namespace
}  // namespace oncard::tools
