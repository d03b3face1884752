// A small web server inside the one event loop: plain, or with a certificate.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "drivers/web/feed.h"
#include "drivers/web/listener.h"

struct MHD_Connection;
struct MHD_Daemon;
struct MHD_Response;

namespace kaori::web {

// Headers by which a visitor is admitted or refused; empty where the request has none.
struct Visitor {
  std::string_view method{};
  std::string_view host{};
  std::string_view origin{};
  std::string_view fetch_site{};  // Sec-Fetch-Site.
};

struct Request {
  std::string method;
  std::string path;  // Without the query.
  std::string body;  // kMostBodyBytes at most; longer ones are refused unread.
  std::string cookie{};
  std::string languages{};  // Accept-Language.
};

struct Reply {
  unsigned status = 200;
  std::string content_type = "text/plain; charset=utf-8";
  std::string body;
  std::string cookie{};  // To be kept by the visitor.
};

inline constexpr std::size_t kMostBodyBytes = 4096;

// PEM, both.
struct Certificate {
  std::string chain;
  std::string key;
};

// Why a visitor is refused, in one line, or nothing.
using Guard = std::function<std::optional<std::string>(const Visitor&)>;

struct ServerOptions {
  std::uint16_t port = 0;  // 0: any free one.
  Reach reach = Reach::kThisMachine;
  std::string address{};                     // One IPv4 address of this machine; empty: as `reach` says.
  std::optional<Certificate> certificate{};  // HTTPS with it, HTTP without.
  unsigned most_connections = 64;
  unsigned most_of_one_address = 64;
  Guard guard{};  // Asked before anything else of a request is looked at.
};

// Does not block; one thread, the loop's. A request that is not whole within 10 s, a reply that is not taken
// within 30 s, and a feed that takes nothing for 30 s are cut off.
class HttpServer {
 public:
  using Answer = std::variant<Reply, Feed*>;  // A Feed must outlive the server.
  using Handler = std::function<Answer(const Request&)>;

  // `loop` and `clock` must outlive the server. Errors:
  //   address_in_use    another program listens on the port
  //   invalid_argument  the certificate and its key are none
  static Result<std::unique_ptr<HttpServer>> Open(ServerOptions options, EventLoop& loop, const Clock& clock,
                                                  Handler handler);
  ~HttpServer();

  std::uint16_t port() const;
  std::size_t connections() const { return lines_.size(); }

  // Sends and receives what can be, and cuts off what is too slow; call it after publishing to a feed and 10
  // times a second at least.
  void Run();

 private:
  struct Exchange;
  struct Calls;  // What MHD calls.
  // A visitor's connection.
  struct Line {
    int fd;
    Duration most;  // For what is under way since `since`; zero: as long as it likes.
    Time since;
  };
  HttpServer(ServerOptions options, EventLoop& loop, const Clock& clock, Handler handler)
      : options_(std::move(options)), loop_(loop), clock_(clock), handler_(std::move(handler)) {}
  Result<void> Start();
  MHD_Response* Respond(const Request& request, MHD_Connection* connection, unsigned* status);
  void CutSlowOnes();
  int pollable() const;

  ServerOptions options_;
  EventLoop& loop_;
  const Clock& clock_;
  Handler handler_;
  MHD_Daemon* daemon_ = nullptr;
  std::vector<Feed*> feeds_;  // Those that were ever answered with.
  std::list<Line> lines_;
};

}  // namespace kaori::web
