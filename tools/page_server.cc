#include "tools/page_server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "base/json_text.h"
#include "base/limits.h"

namespace oncard::tools {
namespace {

/// A browser keeps up to six connections to a server, and each occupies a thread. More requests
/// than these at a time are no page's, and refused: threads are left for the other sessions.
constexpr int kRequestsOfSession = 6;
constexpr size_t kThreads = (kSessionsMax + 4) * kRequestsOfSession;
/// So many requests may use one connection: a run makes many short ones.
constexpr size_t kRequestsOfConnection = 100'000;
constexpr const char* kAddress = "127.0.0.1";
constexpr const char* kJsonLines = "application/x-ndjson";

enum Status : int { kOk = 200, kForbidden = 403, kNotFound = 404, kUnavailable = 503 };

// Another program that listens on the same port would get some of the requests.
void ShareNoPort(int socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

/// Counts a request as long as it lives.
class Counted {
 public:
  explicit Counted(std::atomic<int>* count) : count_(count), number_(++*count) {}
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --*count_; }

  /// With this one.
  int number() const { return number_; }

 private:
  std::atomic<int>* count_;
  int number_;
};

}  // namespace

class PageServer::Routes {
 public:
  Routes(const std::string& folder, std::string token, PageSessions::Maker make, Language language)
      : root_('/' + std::move(token)), sessions_(std::move(make)), language_(language) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_keep_alive_max_count(kRequestsOfConnection);
    server_.set_payload_max_length(kRequestKind.bytes_max);
    server_.set_tcp_nodelay(true);
    server_.set_socket_options(ShareNoPort);
    server_.set_default_headers({{"Cache-Control", "no-store"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"X-Content-Type-Options", "nosniff"}});
    server_.set_mount_point(root_ + '/', folder);
    // Before files are looked for. The body of a request is read first, and its handler asks then.
    server_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          const bool has_body = request.method == "POST" || request.method == "DELETE";
          return has_body || Admits(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                                       : httplib::Server::HandlerResponse::Handled;
        });
    const std::string one = root_ + R"(/sessions/(\d{1,18}))";
    AddPost(root_ + "/sessions", &Routes::Open);
    AddPost(one, &Routes::Answer);
    AddPost(one + "/close", &Routes::Close);
    server_.Delete(one, Admitted(&Routes::Close));
  }

  Result<int> Bind(int port) {
    if (port == 0) {
      port_ = server_.bind_to_any_port(kAddress);
    } else {
      port_ = server_.bind_to_port(kAddress, port) ? port : -1;
    }
    if (port_ > 0) return port_;
    return MakeError(0, "port {0} cannot be used: another program has it, or it is not allowed",
                     "无法使用端口 {0}：已被其他程序占用，或没有权限", port);
  }
  void Serve() { server_.listen_after_bind(); }

 private:
  using Action = void (Routes::*)(const httplib::Request&, httplib::Response&);

  httplib::Server::Handler Admitted(Action action) {
    return [this, action](const httplib::Request& request, httplib::Response& response) {
      if (Admits(request, response)) (this->*action)(request, response);
    };
  }
  void AddPost(const std::string& pattern, Action action) {
    server_.Post(pattern, Admitted(action));
  }

  /// True if a request is addressed to this server by a name of this computer, and comes from its
  /// own page or from none. Otherwise refuses it.
  bool Admits(const httplib::Request& request, httplib::Response& response) const {
    const std::string host = request.get_header_value("Host");
    const bool is_local =
        host == fmt::format("{}:{}", kAddress, port_) || host == fmt::format("localhost:{}", port_);
    const bool is_foreign =
        request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host;
    if (is_local && !is_foreign) return true;
    Refuse(response, kForbidden,
           {"this server answers only its own page", "本服务器只回应自己的页面"});
    return false;
  }

  void Refuse(httplib::Response& response, Status status, const Message& why) const {
    const nlohmann::ordered_json answer = {
        {"id", nullptr}, {"ok", false}, {"error", why.In(language_)}};
    response.status = status;
    response.set_content(JsonText(answer) + '\n', kJsonLines);
  }

  void Open(const httplib::Request& /*request*/, httplib::Response& response) {
    if (const auto number = sessions_.Open(Now())) {
      const nlohmann::ordered_json answer = {{"ok", true}, {"session", *number}};
      response.set_content(JsonText(answer) + '\n', kJsonLines);
      return;
    }
    Refuse(response, kUnavailable,
           MakeMessage("there are already {0} sessions: close a page, or start oncard serve anew",
                       "已有 {0} 个会话：请关闭一个页面，或重新启动 oncard serve", kSessionsMax));
  }

  void Answer(const httplib::Request& request, httplib::Response& response) {
    const std::shared_ptr<PageSession> session = sessions_.Use(Number(request), Now());
    if (session == nullptr) return RefuseUnknown(request, response);
    const Counted request_of_session(&session->requests);
    if (request_of_session.number() > kRequestsOfSession) {
      return Refuse(response, kUnavailable,
                    MakeMessage("{0} requests of session {1} wait already: send the next one after "
                                "an answer",
                                "会话 {1} 已有 {0} 个请求在等待：请收到回答后再发送",
                                kRequestsOfSession, Number(request)));
    }
    const std::lock_guard lock(session->mutex);
    if (session->closed) return RefuseUnknown(request, response);
    response.set_content(session->host.Handle(request.body), kJsonLines);
  }

  void Close(const httplib::Request& request, httplib::Response& response) {
    if (!sessions_.Close(Number(request))) return RefuseUnknown(request, response);
    response.set_content("{\"ok\":true}\n", kJsonLines);
  }

  void RefuseUnknown(const httplib::Request& request, httplib::Response& response) const {
    Refuse(response, kNotFound,
           MakeMessage("there is no session {0}: it has ended, or is of an earlier oncard serve",
                       "没有会话 {0}：已结束，或属于之前的 oncard serve", Number(request)));
  }

  static PageSessions::Time Now() { return std::chrono::steady_clock::now(); }
  // The pattern allows digits only, and no more than fit.
  static uint64_t Number(const httplib::Request& request) {
    return std::stoull(request.matches[1].str());
  }

  std::string root_;
  PageSessions sessions_;
  Language language_;
  int port_ = 0;
  httplib::Server server_;
};

std::string RandomToken() {
  std::random_device random;
  std::string token;
  for (int word = 0; word < 4; ++word) token += fmt::format("{:08x}", random());
  return token;
}

PageServer::PageServer(const std::string& folder, std::string token, PageSessions::Maker make,
                       Language language)
    : routes_(std::make_unique<Routes>(folder, std::move(token), std::move(make), language)) {}

PageServer::~PageServer() = default;

Result<int> PageServer::Bind(int port) { return routes_->Bind(port); }

void PageServer::Serve() { routes_->Serve(); }

}  // namespace oncard::tools
