// oncard serve: the page and sessions over HTTP, for this computer alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <signal.h>

#include <chrono>
#include <future>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "tests/tools/process.h"

namespace oncard::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Json = nlohmann::json;

constexpr const char* kHello = R"({"id":1,"request":"hello","arguments":{"protocol":1}})";

class ServeTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.Write("outside.txt", "not for others");
    folder_.Write("page/index.html", "<title>oncard</title>");
    for (const char* name : {"main.js", "main.css", "icon.svg", "oncard.wasm", "data.json"}) {
      folder_.Write(std::string("page/") + name, name);
    }
    server_.emplace(std::vector<std::string>{"serve", "--page", folder_.path() + "/page"});
    address_ = server_->FirstLine();
    static const std::regex kAddress(R"(http://127\.0\.0\.1:(\d+)(/[0-9a-f]{32}/)\?engine=here)");
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(address_, parts, kAddress)) << address_;
    port_ = std::stoi(parts[1]);
    root_ = parts[2];
    client_.emplace("127.0.0.1", port_);
  }

  /// The status of the answer to a request for a file.
  int StatusOf(const std::string& path, const httplib::Headers& headers = {}) {
    const auto response = client_->Get(path, headers);
    return response ? response->status : 0;
  }
  /// The answer to a request with a body.
  httplib::Response Post(const std::string& path, const std::string& body = {},
                         const httplib::Headers& headers = {}) {
    auto response = client_->Post(root_ + path, headers, body, "text/plain");
    return response ? *response : httplib::Response{};
  }
  /// The path of a new session.
  std::string Open() {
    const Json answer = Json::parse(Post("sessions").body);
    return "sessions/" + answer["session"].dump();
  }

  const ScratchFolder folder_;
  std::optional<RunningOncard> server_;
  std::string address_;
  int port_ = 0;
  std::string root_;
  std::optional<httplib::Client> client_;
};

TEST_F(ServeTest, HandsOutThePage) {
  const auto page = client_->Get(root_ + "?engine=here");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_EQ(page->body, "<title>oncard</title>");
  EXPECT_EQ(page->get_header_value("Cache-Control"), "no-store");
}

TEST_F(ServeTest, FilesHaveTheirTypes) {
  const std::pair<const char*, const char*> kTypes[] = {{"", "text/html"},
                                                        {"main.js", "text/javascript"},
                                                        {"main.css", "text/css"},
                                                        {"icon.svg", "image/svg+xml"},
                                                        {"oncard.wasm", "application/wasm"},
                                                        {"data.json", "application/json"}};
  for (const auto& [name, type] : kTypes) {
    const auto file = client_->Get(root_ + name);
    ASSERT_TRUE(file) << name;
    EXPECT_EQ(file->get_header_value("Content-Type"), type) << name;
  }
}

TEST_F(ServeTest, NothingExistsWithoutTheToken) {
  const std::string wrong = "/" + std::string(32, '0') + "/";
  for (const std::string& path : {std::string("/"), std::string("/index.html"), wrong}) {
    EXPECT_EQ(StatusOf(path), 404) << path;
  }
  for (const std::string& path : {std::string("/sessions"), wrong + "sessions"}) {
    const auto response = client_->Post(path, "", "text/plain");
    ASSERT_TRUE(response) << path;
    EXPECT_EQ(response->status, 404) << path;
  }
}

TEST_F(ServeTest, NoPathLeadsOutOfThePage) {
  EXPECT_EQ(StatusOf(root_ + "../outside.txt"), 404);
  EXPECT_EQ(StatusOf(root_ + "%2e%2e/outside.txt"), 404);
  EXPECT_EQ(StatusOf(root_ + "missing.js"), 404);
}

TEST_F(ServeTest, RefusesOtherNamesOfThisComputer) {
  const std::string port = ":" + std::to_string(port_);
  EXPECT_EQ(StatusOf(root_, {{"Host", "localhost" + port}}), 200);
  for (const std::string& host :
       {"oncard.example" + port, std::string("127.0.0.1"), "127.0.0.1.oncard.example" + port}) {
    EXPECT_EQ(StatusOf(root_, {{"Host", host}}), 403) << host;
    EXPECT_EQ(Post("sessions", "", {{"Host", host}}).status, 403) << host;
  }
}

TEST_F(ServeTest, RefusesPagesOfOthers) {
  const std::string own = "http://127.0.0.1:" + std::to_string(port_);
  EXPECT_EQ(Post("sessions", "", {{"Origin", own}}).status, 200);
  for (const char* origin : {"http://oncard.example", "null", "http://127.0.0.1"}) {
    EXPECT_EQ(Post("sessions", "", {{"Origin", origin}}).status, 403) << origin;
    EXPECT_EQ(StatusOf(root_, {{"Origin", origin}}), 403) << origin;
  }
}

TEST_F(ServeTest, ASessionAnswersRequests) {
  const std::string session = Open();
  const httplib::Response hello = Post(session, kHello);
  EXPECT_EQ(hello.get_header_value("Content-Type"), "application/x-ndjson");
  EXPECT_THAT(hello.body, StartsWith(R"({"id":1,"ok":true,"result":{"protocol":1,)"));
  const Json load = {
      {"id", 2},
      {"request", "load"},
      {"arguments",
       {{"main", "p.c"}, {"files", {{"p.c", "int x;\nint f()\n{\n  x = 5;\n  return x;\n}\n"}}}}}};
  EXPECT_THAT(Post(session, load.dump()).body, HasSubstr("\"compiled\":true"));
  const Json end = Json::parse(
      Post(session, R"({"id":3,"request":"forward","arguments":{"goal":"stop"}})").body);
  EXPECT_EQ(end["result"]["stop"]["reason"], "end");
  EXPECT_EQ(end["result"]["state"]["threads"][0]["result"], 5);
}

TEST_F(ServeTest, AnswersAreThoseOfDebug) {
  const std::string load =
      R"({"id":1,"request":"load","arguments":{"main":"p.c","files":{"p.c":"int f()\n{\n  return 1;\n}\n"}}})";
  folder_.Write("requests", load + "\n");
  const ProcessResult debug = RunProgram(
      {"sh", "-c", ONCARD_BUILD_DIR "/bin/oncard debug --stdio < requests"}, folder_.path());
  EXPECT_EQ(Post(Open(), load).body, debug.out);
}

TEST_F(ServeTest, EventsAreLinesOfTheAnswer) {
  const std::string session = Open();
  Post(
      session,
      R"({"id":1,"request":"load","arguments":{"main":"p.c","files":{"p.c":"int x;\nint f()\n{\n  x = 5;\n  return x;\n}\n"}}})");
  Post(session,
       R"({"id":2,"request":"set_stops","arguments":{"lines":[{"line":5,"log":"x is {x}"}]}})");
  const std::string answer =
      Post(session, R"({"id":3,"request":"forward","arguments":{"goal":"stop"}})").body;
  EXPECT_THAT(answer, AllOf(StartsWith(R"({"event":"log")"), HasSubstr("x is 5"),
                            HasSubstr("\n{\"id\":3,\"ok\":true")));
}

TEST_F(ServeTest, SessionsKnowNothingOfEachOther) {
  const std::string first = Open();
  Post(
      first,
      R"({"id":1,"request":"load","arguments":{"main":"p.c","files":{"p.c":"int f()\n{\n  return 1;\n}\n"}}})");
  const std::string state = R"({"id":2,"request":"state"})";
  EXPECT_TRUE(Json::parse(Post(first, state).body)["ok"]);
  EXPECT_FALSE(Json::parse(Post(Open(), state).body)["ok"]);
}

TEST_F(ServeTest, ASessionThatHasEndedIsUnknown) {
  const std::string first = Open();
  const std::string second = Open();
  ASSERT_TRUE(client_->Delete(root_ + first));
  EXPECT_EQ(Post(second + "/close").status, 200);
  for (const std::string& path : {first, second, std::string("sessions/77")}) {
    const httplib::Response refused = Post(path, kHello);
    EXPECT_EQ(refused.status, 404) << path;
    EXPECT_THAT(Json::parse(refused.body)["error"].get<std::string>(),
                StartsWith("there is no session "))
        << path;
  }
}

TEST_F(ServeTest, RefusesMoreThanSixteenSessions) {
  std::string last;
  for (int i = 0; i < 16; ++i) last = Open();
  const httplib::Response refused = Post("sessions");
  EXPECT_EQ(refused.status, 503);
  EXPECT_THAT(Json::parse(refused.body)["error"].get<std::string>(),
              HasSubstr("there are already 16 sessions"));
  Post(last + "/close");
  EXPECT_EQ(Post("sessions").status, 200);
}

/// A session that walks for half a minute unless something ends it.
class LongWalk {
 public:
  LongWalk(int port, std::string address)
      : client_("127.0.0.1", port), address_(std::move(address)) {
    client_.set_read_timeout(60);
    client_.Post(
        address_,
        R"({"id":1,"request":"load","arguments":{"main":"p.c","files":{"p.c":"int x;\nint f()\n{\nL:\n  x = 1;\n  goto L;\n}\n"}}})",
        "text/plain");
    answer_ = std::async(std::launch::async, [this] {
      const auto response = client_.Post(
          address_,
          R"({"id":2,"request":"forward","arguments":{"goal":"rest","budget":1000000000}})",
          "text/plain");
      return response ? response->body : std::string();
    });
  }
  bool Goes() const {
    return answer_.wait_for(std::chrono::milliseconds(300)) == std::future_status::timeout;
  }
  /// The moment at which it ended.
  int64_t End() { return Json::parse(answer_.get())["result"]["state"]["moment"]; }

 private:
  httplib::Client client_;
  std::string address_;
  std::future<std::string> answer_;
};

TEST_F(ServeTest, ClosingASessionEndsItsWalk) {
  const std::string session = Open();
  LongWalk walk(port_, root_ + session);
  ASSERT_TRUE(walk.Goes());
  EXPECT_EQ(Post(session + "/close").status, 200);
  EXPECT_LT(walk.End(), 1'000'000'000);
}

TEST_F(ServeTest, ASessionHasSixRequestsAtATime) {
  const std::string session = Open();
  LongWalk walk(port_, root_ + session);
  ASSERT_TRUE(walk.Goes());
  const auto say_hello = [this, &session] {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(60);
    const auto response = client.Post(root_ + session, kHello, "text/plain");
    return response ? response->status : 0;
  };
  std::vector<std::future<int>> waiting;
  for (int i = 0; i < 5; ++i) waiting.push_back(std::async(std::launch::async, say_hello));
  for (const std::future<int>& status : waiting) {
    EXPECT_EQ(status.wait_for(std::chrono::milliseconds(200)), std::future_status::timeout);
  }
  for (int i = 0; i < 20; ++i) EXPECT_EQ(say_hello(), 503);
  EXPECT_EQ(Post(Open(), kHello).status, 200);
  EXPECT_EQ(Post(session + "/close").status, 200);
  EXPECT_LT(walk.End(), 1'000'000'000);
  for (std::future<int>& status : waiting) EXPECT_EQ(status.get(), 404);
}

TEST_F(ServeTest, EndsWithZeroAtASignal) {
  EXPECT_EQ(StatusOf(root_), 200);
  EXPECT_EQ(server_->Stop(SIGINT), 0);
}

TEST_F(ServeTest, APortHasOneServer) {
  const ProcessResult second =
      RunOncard({"serve", "--page", folder_.path() + "/page", "--port", std::to_string(port_)});
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_THAT(second.err, HasSubstr("port " + std::to_string(port_) + " cannot be used"));
  EXPECT_EQ(second.out, "");
}

TEST_F(ServeTest, EachServerHasItsOwnToken) {
  const RunningOncard other({"serve", "--page", folder_.path() + "/page"});
  EXPECT_EQ(other.FirstLine().find(root_), std::string::npos);
  EXPECT_THAT(other.FirstLine(), StartsWith("http://127.0.0.1:"));
}

TEST(ServeCommand, SpeaksTheLanguageOfItsCommand) {
  const ScratchFolder folder;
  folder.Write("index.html", "");
  const RunningOncard server({"--lang=zh", "serve", "--page", folder.path()});
  const std::string address = server.FirstLine();
  const size_t path = address.find('/', 7);
  httplib::Client client(address.substr(0, path));
  const auto refused =
      client.Post(address.substr(path, address.find('?') - path) + "sessions/1", "", "text/plain");
  ASSERT_TRUE(refused);
  EXPECT_THAT(refused->body, HasSubstr("没有会话 1"));
}

TEST(ServeCommand, NeedsAPage) {
  const ScratchFolder empty;
  const ProcessResult result = RunOncard({"serve", "--page", empty.path()});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, AllOf(HasSubstr(empty.path()), HasSubstr("--page"),
                                HasSubstr("./x demo-web"), HasSubstr("web/playground/dist/page")));
}

TEST(ServeCommand, FindsThePageOfItsInstallation) {
  const ScratchFolder root;
  std::filesystem::create_directories(root.path() + "/bin");
  std::filesystem::copy(ONCARD_BUILD_DIR "/bin/oncard", root.path() + "/bin");
  const ProcessResult without = RunProgram({root.path() + "/bin/oncard", "serve"});
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_THAT(without.err, HasSubstr(root.path() + "/share/oncard/page"));
  root.Write("share/oncard/page/index.html", "");
  const RunningOncard with({"serve"}, root.path() + "/bin/oncard");
  EXPECT_THAT(with.FirstLine(), StartsWith("http://127.0.0.1:"));
}

}  // namespace
}  // namespace oncard::tools
