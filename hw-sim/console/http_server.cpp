#include "hw-sim/console/http_server.h"

#include <arpa/inet.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "hw-sim/console/guard.h"

namespace kaori::console {
namespace {

constexpr unsigned kMostConnections = 64;
constexpr unsigned kIdleTimeout_s = 30;
constexpr int kRunsAtOnce = 64;  // A visitor who never stops sending must not stop the loop.

// The page may do nothing but talk to us, and no other page may hold it in a frame.
constexpr std::pair<const char*, const char*> kEveryReply[] = {
    {"Cache-Control", "no-store"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
};

std::string_view Header(MHD_Connection* connection, const char* name) {
  const char* value = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
  return value == nullptr ? std::string_view() : value;
}

std::optional<std::string> Refuse(MHD_Connection* connection) {
  return Refusal({.host = Header(connection, "Host"),
                  .origin = Header(connection, "Origin"),
                  .fetch_site = Header(connection, "Sec-Fetch-Site")});
}

MHD_Response* Text(std::string_view text) {
  auto* bytes = const_cast<char*>(text.data());  // Copied: MHD's signature is older than const.
  MHD_Response* response = MHD_create_response_from_buffer(text.size(), bytes, MHD_RESPMEM_MUST_COPY);
  return response;
}

// Takes `response`; MHD_NO closes the connection.
MHD_Result Send(MHD_Connection* connection, unsigned status, MHD_Response* response) {
  if (response == nullptr) return MHD_NO;
  for (const auto& [name, value] : kEveryReply) MHD_add_response_header(response, name, value);
  const MHD_Result queued = MHD_queue_response(connection, status, response);
  MHD_destroy_response(response);
  return queued;
}

MHD_Result SendText(MHD_Connection* connection, unsigned status, std::string_view text) {
  return Send(connection, status, Text(fmt::format("{}\n", text)));
}

Result<UniqueFd> ListenOnLoopback(std::uint16_t port) {
  const std::string attempt = fmt::format("listen on 127.0.0.1:{}", port);
  UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listener.valid()) return FailErrno(attempt);
  const int yes = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) < 0)
    return FailErrno(attempt);
  if (::listen(listener.get(), SOMAXCONN) < 0) return FailErrno(attempt);
  return listener;
}

}  // namespace

// One request while it arrives.
struct HttpServer::Exchange {
  Request request;
  bool too_long = false;
};

struct HttpServer::Calls {
  static MHD_Result Begin(MHD_Connection* connection, const char* path, const char* method, void** exchange) {
    if (const auto refusal = Refuse(connection)) return SendText(connection, MHD_HTTP_FORBIDDEN, *refusal);
    *exchange = new Exchange{{method, path, {}}};  // Ended by Complete, whatever happens.
    return MHD_YES;
  }

  static void Take(Exchange& exchange, std::string_view part) {
    exchange.too_long |= exchange.request.body.size() + part.size() > kMostBodyBytes;
    if (!exchange.too_long) exchange.request.body += part;
  }

  // MHD's access handler: once for the headers, once for each part of the body, once at the end.
  static MHD_Result Access(void* context, MHD_Connection* connection, const char* path, const char* method,
                           const char*, const char* part, std::size_t* part_bytes, void** slot) {
    if (*slot == nullptr) return Begin(connection, path, method, slot);
    auto& exchange = *static_cast<Exchange*>(*slot);
    if (*part_bytes > 0) {
      Take(exchange, {part, *part_bytes});
      *part_bytes = 0;
      return MHD_YES;
    }
    if (exchange.too_long) return SendText(connection, MHD_HTTP_CONTENT_TOO_LARGE, "4096 bytes at most");
    unsigned status = MHD_HTTP_OK;
    MHD_Response* response =
        static_cast<HttpServer*>(context)->Respond(exchange.request, connection, &status);
    return Send(connection, status, response);
  }

  static void Complete(void*, MHD_Connection*, void** slot, MHD_RequestTerminationCode) {
    delete static_cast<Exchange*>(*slot);
    *slot = nullptr;
  }
};

Result<std::unique_ptr<HttpServer>> HttpServer::Open(std::uint16_t port, EventLoop& loop, Handler handler) {
  auto listener = ListenOnLoopback(port);
  if (!listener) return tl::unexpected(listener.error());
  std::unique_ptr<HttpServer> server(new HttpServer(loop, std::move(handler)));
  server->daemon_ =
      MHD_start_daemon(MHD_USE_EPOLL | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr, &Calls::Access,
                       server.get(), MHD_OPTION_LISTEN_SOCKET, listener->get(), MHD_OPTION_CONNECTION_LIMIT,
                       kMostConnections, MHD_OPTION_CONNECTION_TIMEOUT, kIdleTimeout_s,
                       MHD_OPTION_NOTIFY_COMPLETED, &Calls::Complete, nullptr, MHD_OPTION_END);
  if (server->daemon_ == nullptr) return Fail(std::errc::io_error, "start the web server");
  (void)listener->release();  // MHD closes it.
  auto watched = loop.Watch(server->pollable(), [self = server.get()] { self->Run(); });
  if (!watched) return tl::unexpected(watched.error());
  return server;
}

HttpServer::~HttpServer() {
  if (daemon_ == nullptr) return;
  loop_.Forget(pollable());
  for (Feed* feed : feeds_) feed->End();  // MHD refuses to stop while a reply sleeps.
  MHD_run(daemon_);
  MHD_stop_daemon(daemon_);
}

std::uint16_t HttpServer::port() const {
  return MHD_get_daemon_info(daemon_, MHD_DAEMON_INFO_BIND_PORT)->port;
}

int HttpServer::pollable() const {
  return MHD_get_daemon_info(daemon_, MHD_DAEMON_INFO_EPOLL_FD)->epoll_fd;
}

void HttpServer::Run() {
  for (int run = 0; run < kRunsAtOnce; ++run) {
    MHD_run(daemon_);
    MHD_UNSIGNED_LONG_LONG wait_ms = 0;
    if (MHD_get_timeout(daemon_, &wait_ms) == MHD_NO || wait_ms > 0) return;
  }
}

MHD_Response* HttpServer::Respond(const Request& request, MHD_Connection* connection, unsigned* status) {
  const Answer answer = handler_(request);
  if (Feed* const* feed = std::get_if<Feed*>(&answer)) {
    if (std::ranges::find(feeds_, *feed) == feeds_.end()) feeds_.push_back(*feed);
    return (*feed)->Listen(connection);
  }
  const auto& reply = std::get<Reply>(answer);
  *status = reply.status;
  MHD_Response* response = Text(reply.body);
  if (response != nullptr)
    MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, reply.content_type.c_str());
  return response;
}

}  // namespace kaori::console
