// A small web server in the program's event loop: HTTP, or HTTPS with a certificate.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "drivers/web/connections.h"
#include "drivers/web/feed.h"
#include "drivers/web/listener.h"

struct MHD_Connection;
struct MHD_Daemon;
struct MHD_Response;

namespace kaori::web {

// The headers by which a guard admits or refuses a request; empty where it has none. Browsers set Origin
// and Sec-Fetch-Site by themselves, and no page can forge them. The views end with the guard's call.
struct Visitor {
  // "GET", "POST" ...
  std::string_view method{};
  // The host that the client believes to speak to, with its port.
  std::string_view host{};
  // "scheme://host:port" of the page that sent the request.
  std::string_view origin{};
  std::string_view fetch_site{};  // Sec-Fetch-Site.
};

// A whole request. The strings are the client's own: of any content, and bounded in length by MHD.
struct Request {
  // "GET", "POST" ...
  std::string method;
  std::string path;  // Without the query.
  std::string body;  // ServerOptions::most_body_bytes at most; longer ones are refused unread.
  // As the client sent it, unparsed.
  std::string cookie{};
  std::string languages{};  // Its Accept-Language.
};

// A whole reply.
struct Reply {
  // An HTTP status (RFC 9110, 15).
  unsigned status = 200;
  // With its character set, as a header has it.
  std::string content_type = "text/plain; charset=utf-8";
  std::string body;
  std::string cookie{};  // A Set-Cookie header; empty: none.
  // In place of the body where it is valid: a regular file, all of it, which a browser saves under this name. The name has neither
  // quotes nor line ends.
  UniqueFd file{};
  std::string file_name{};
};

// Far more than most messages of our pages. It bounds what a client can make the program keep.
inline constexpr std::size_t kMostBodyBytes = 4096;

// A certificate chain and its private key, both as PEM.
struct Certificate {
  // The server's own certificate first, then those that signed it.
  std::string chain;
  // Of the server's own certificate.
  std::string key;
};

// Why a request is refused, in one line, which the client gets with status 403; none: it is accepted.
// Called for each request, in the loop's thread.
using Guard = std::function<std::optional<std::string>(const Visitor&)>;

// What a server is and whom it serves. The numbers of connections bound the
// descriptors that clients can use up.
struct ServerOptions {
  std::uint16_t port = 0;  // 0: any free one.
  // Counts where `address` is empty.
  Reach reach = Reach::kThisMachine;
  std::string address{};                     // One IPv4 address of this machine; empty: as `reach` says.
  std::optional<Certificate> certificate{};  // HTTPS with it, HTTP without.
  // Connections at a time, of all clients and of one address. Who says nothing or receives nothing keeps nobody waiting: one of them is
  // closed for one more (Connections::Add). Feeds and files go on.
  unsigned most_connections = 64;
  unsigned most_of_one_address = 24;             // A browser opens six for each page.
  std::size_t most_body_bytes = kMostBodyBytes;  // Of a request.
  Guard guard{};  // Called with the headers, before the body is read; null: all are accepted.
};

// Serves pages and feeds by libmicrohttpd, which is driven by the program's own loop and has no thread. HTTPS is TLS 1.2 or
// 1.3, with a key for each session and authenticated encryption alone (RFC 9325). A path with "%00" gets 400, and so does a
// request that can be read in two ways, with two hosts, origins or lengths (RFC 9112, 6.3). One thread, that of the loop. No
// call blocks. A connection is closed whose request is not whole within 10 s, whose reply is not received within 30 s, or whose
// feed or file receives nothing for 30 s.
class HttpServer {
 public:
  using Answer = std::variant<Reply, Feed*>;  // A Feed must outlive the server.
  // Called with each whole request; what it returns is sent. Runs inside Run, so it must not block.
  using Handler = std::function<Answer(const Request&)>;

  // Listens and joins the loop. The handler is kept and called until the server ends; what it refers to
  // must outlive it, as `loop` and `clock` must. Errors:
  //   address_in_use    another program listens on the port
  //   permission_denied the port is below 1024, and this program may not open it
  //   invalid_argument  the certificate or its key is not valid
  //   io_error          the server could not be started
  static Result<std::unique_ptr<HttpServer>> Open(ServerOptions options, EventLoop& loop, const Clock& clock,
                                                  Handler handler);
  // Leaves the loop, ends all feeds and closes all connections.
  ~HttpServer();

  // The port that is listened on.
  std::uint16_t port() const;
  // How many connections are open.
  std::size_t connections() const { return connections_.CountOf(std::nullopt); }

  // Sends and receives what is possible now, and closes connections that are too slow. To be
  // called after a feed was published to, and 10 times a second at least: MHD's own time-outs have
  // no descriptor that the loop could watch.
  void Run();

 private:
  // A request while it arrives.
  struct Exchange;
  struct Callbacks;  // Those that MHD calls.
  HttpServer(ServerOptions options, EventLoop& loop, const Clock& clock, Handler handler)
      : options_(std::move(options)),
        loop_(loop),
        clock_(clock),
        handler_(std::move(handler)),
        connections_(options_.most_connections, options_.most_of_one_address, clock) {}
  // Opens the socket and starts MHD on it. Errors: as Open.
  Result<void> Start();
  // The handler's answer as MHD's response; null when memory is short, or a file cannot be looked at.
  MHD_Response* Respond(const Request& request, MHD_Connection* connection, unsigned* status);
  // MHD's epoll descriptor, which the loop watches.
  int pollable() const;

  ServerOptions options_;
  EventLoop& loop_;
  const Clock& clock_;
  Handler handler_;
  // Null before Start, and where that failed.
  MHD_Daemon* daemon_ = nullptr;
  std::vector<Feed*> feeds_;  // Every feed that a handler returned so far.
  // MHD keeps pointers to each.
  Connections connections_;
};

}  // namespace kaori::web
