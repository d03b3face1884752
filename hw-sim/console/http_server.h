// A small web server on 127.0.0.1, inside the one event loop.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "hw-sim/console/feed.h"

struct MHD_Connection;
struct MHD_Daemon;
struct MHD_Response;

namespace kaori::console {

struct Request {
  std::string method;
  std::string path;  // Without the query.
  std::string body;  // kMostBodyBytes at most; longer ones are refused unread.
};

struct Reply {
  unsigned status = 200;
  std::string content_type = "text/plain; charset=utf-8";
  std::string body;
};

inline constexpr std::size_t kMostBodyBytes = 4096;

// Does not block; one thread, the loop's. Visitors that guard.h refuses never reach the handler.
class HttpServer {
 public:
  using Answer = std::variant<Reply, Feed*>;  // A Feed must outlive the server.
  using Handler = std::function<Answer(const Request&)>;

  // Listens on `port`, 0 for any free one. `loop` must outlive the server. Errors:
  //   address_in_use   another program listens on the port
  static Result<std::unique_ptr<HttpServer>> Open(std::uint16_t port, EventLoop& loop, Handler handler);
  ~HttpServer();

  std::uint16_t port() const;

  // Sends and receives what can be; call it after publishing to a feed and 10 times a second at least.
  void Run();

 private:
  struct Exchange;
  struct Calls;  // What MHD calls.
  HttpServer(EventLoop& loop, Handler handler) : loop_(loop), handler_(std::move(handler)) {}
  MHD_Response* Respond(const Request& request, MHD_Connection* connection, unsigned* status);
  int pollable() const;

  EventLoop& loop_;
  Handler handler_;
  MHD_Daemon* daemon_ = nullptr;
  std::vector<Feed*> feeds_;  // Those that were ever answered with.
};

}  // namespace kaori::console
