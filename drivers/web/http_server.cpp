#include "drivers/web/http_server.h"

#include <microhttpd.h>
#include <netinet/in.h>
#include <strings.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "drivers/web/response.h"

namespace kaori::web {
namespace {

// MHD counts from the last byte that went either way: it ends feeds that nobody receives.
constexpr unsigned kIdleTimeout_s = 30;
constexpr Duration kRequestLimit = std::chrono::seconds(10);  // Handshake, headers and body.
constexpr Duration kReplyLimit = std::chrono::seconds(30);    // A reply of one piece.
constexpr int kRunsAtOnce = 64;  // A client that never stops sending must not hold the loop.
// MHD counts connections that we have closed and it has not noticed; it accepts no more than ten before it
// looks.
constexpr unsigned kMoreOfMhd = 16;
// In GnuTLS's words: no version, cipher or key exchange that RFC 9325 advises against.
constexpr const char* kTlsPriorities =
    "NORMAL:-VERS-ALL:+VERS-TLS1.3:+VERS-TLS1.2:-CIPHER-ALL:+AES-256-GCM:+CHACHA20-POLY1305:+AES-128-GCM:"
    "-MAC-ALL:+AEAD:-KX-ALL:+ECDHE-ECDSA:+ECDHE-RSA";
constexpr std::string_view kZeroByte = "%00";

// A page of ours may load nothing from elsewhere, and no other page may put it into a frame: a page on
// the internet that guesses the box's address can neither read nor press anything.
constexpr std::pair<const char*, const char*> kEveryReply[] = {
    {"Cache-Control", "no-store"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
};

// The first header of this name; empty where there is none.
std::string_view Header(MHD_Connection* connection, const char* name) {
  const char* value = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, name);
  return value == nullptr ? std::string_view() : value;
}

// Two programs on its way could read it in two ways: what counts may be there once, and one header alone says how long it is.
bool IsAmbiguous(MHD_Connection* connection) {
  std::array<int, 3> counts{};
  const auto count = [](void* into, MHD_ValueKind, const char* name, const char*) {
    auto& [hosts, origins, lengths] = *static_cast<std::array<int, 3>*>(into);
    const auto is = [name](const char* other) { return ::strcasecmp(name, other) == 0; };
    hosts += is("Host") ? 1 : 0;
    origins += is("Origin") ? 1 : 0;
    lengths += is("Content-Length") || is("Transfer-Encoding") ? 1 : 0;
    return MHD_YES;
  };
  MHD_get_connection_values(connection, MHD_HEADER_KIND, count, &counts);
  return std::ranges::max(counts) > 1;
}

// Owns `response`. MHD_NO closes the connection.
MHD_Result Send(MHD_Connection* connection, unsigned status, MHD_Response* response) {
  if (response == nullptr) return MHD_NO;
  for (const auto& [name, value] : kEveryReply) MHD_add_response_header(response, name, value);
  const MHD_Result queued = MHD_queue_response(connection, status, response);
  MHD_destroy_response(response);
  return queued;
}

MHD_Result SendText(MHD_Connection* connection, unsigned status, std::string_view text) {
  return Send(connection, status, TextResponse(fmt::format("{}\n", text)));
}

}  // namespace

// One request while it arrives.
struct HttpServer::Exchange {
  Request request;
  bool too_long = false;
};

struct HttpServer::Callbacks {
  static Connection& ConnectionOf(MHD_Connection* connection) {
    return *static_cast<Connection*>(
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT)->socket_context);
  }

  // Its request begins, or is whole and the reply begins.
  static void BeginRequest(HttpServer& server, MHD_Connection* connection) {
    Connection& entry = ConnectionOf(connection);
    entry.limit = kRequestLimit;
    entry.since = server.clock_.now();
    entry.is_idle = true;
  }
  static void BeginReply(HttpServer& server, MHD_Connection* connection) {
    Connection& entry = ConnectionOf(connection);
    entry.limit = kReplyLimit;
    entry.since = server.clock_.now();
    entry.is_idle = false;
  }

  // MHD's decoder ends a path at its first zero byte. Such a path stays as it was sent, and Begin refuses it.
  static std::size_t Decode(void*, MHD_Connection*, char* text) {
    const std::string_view sent = text;
    return sent.find(kZeroByte) == std::string_view::npos ? MHD_http_unescape(text) : sent.size();
  }

  // MHD's notification of connections.
  static void Connect(void* context, MHD_Connection* connection, void** slot,
                      MHD_ConnectionNotificationCode notice) {
    auto& server = *static_cast<HttpServer*>(context);
    if (notice == MHD_CONNECTION_NOTIFY_CLOSED) {
      server.connections_.Remove(static_cast<const Connection*>(*slot));
      return;
    }
    const int fd = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd;
    const sockaddr* client =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS)->client_addr;
    const std::uint32_t address = reinterpret_cast<const sockaddr_in*>(client)->sin_addr.s_addr;
    *slot = &server.connections_.Add(fd, address, kRequestLimit);
  }

  // The guard's answer to a request's headers.
  static std::optional<std::string> Refuse(const HttpServer& server, MHD_Connection* connection,
                                           const char* method) {
    if (!server.options_.guard) return std::nullopt;
    return server.options_.guard({.method = method,
                                  .host = Header(connection, "Host"),
                                  .origin = Header(connection, "Origin"),
                                  .fetch_site = Header(connection, "Sec-Fetch-Site")});
  }

  static MHD_Result Begin(HttpServer& server, MHD_Connection* connection, const char* path,
                          const char* method, void** exchange) {
    const auto refuse = [&](unsigned status, std::string_view reason) {
      BeginReply(server, connection);
      return SendText(connection, status, reason);
    };
    if (const auto refusal = Refuse(server, connection, method)) return refuse(MHD_HTTP_FORBIDDEN, *refusal);
    if (std::string_view(path).find(kZeroByte) != std::string_view::npos)
      return refuse(MHD_HTTP_BAD_REQUEST, "a path has no zero byte");
    if (IsAmbiguous(connection))
      return refuse(MHD_HTTP_BAD_REQUEST, "a request has one host, one origin and one length");
    // Owned by MHD's connection until Complete deletes it, whatever happens.
    *exchange = new Exchange{{.method = method,
                              .path = path,
                              .body = {},
                              .cookie = std::string(Header(connection, "Cookie")),
                              .languages = std::string(Header(connection, "Accept-Language"))}};
    return MHD_YES;
  }

  static void Append(const HttpServer& server, Exchange& exchange, std::string_view part) {
    // The rest of a body that is too long is read and dropped, so that the reply reaches the client.
    exchange.too_long |= exchange.request.body.size() + part.size() > server.options_.most_body_bytes;
    if (!exchange.too_long) exchange.request.body += part;
  }

  // MHD's access handler: once for the headers, once for each part of the body, once at the end.
  // NOLINTNEXTLINE(readability-function-size): the parameters are MHD's.
  static MHD_Result Access(void* context, MHD_Connection* connection, const char* path, const char* method,
                           const char*, const char* part, std::size_t* part_bytes, void** slot) {
    auto& server = *static_cast<HttpServer*>(context);
    if (*slot == nullptr) return Begin(server, connection, path, method, slot);
    auto& exchange = *static_cast<Exchange*>(*slot);
    if (*part_bytes > 0) {
      Append(server, exchange, {part, *part_bytes});
      *part_bytes = 0;
      return MHD_YES;
    }
    BeginReply(server, connection);
    if (exchange.too_long)
      return SendText(connection, MHD_HTTP_CONTENT_TOO_LARGE,
                      fmt::format("{} bytes at most", server.options_.most_body_bytes));
    unsigned status = MHD_HTTP_OK;
    MHD_Response* response = server.Respond(exchange.request, connection, &status);
    return Send(connection, status, response);
  }

  static void Complete(void* context, MHD_Connection* connection, void** slot, MHD_RequestTerminationCode) {
    delete static_cast<Exchange*>(*slot);
    *slot = nullptr;
    BeginRequest(*static_cast<HttpServer*>(context), connection);
  }
};

Result<std::unique_ptr<HttpServer>> HttpServer::Open(ServerOptions options, EventLoop& loop,
                                                     const Clock& clock, Handler handler) {
  std::unique_ptr<HttpServer> server(new HttpServer(std::move(options), loop, clock, std::move(handler)));
  if (auto started = server->Start(); !started) return tl::unexpected(started.error());
  auto watched = loop.Watch(server->pollable(), [self = server.get()] { self->Run(); });
  if (!watched) return tl::unexpected(watched.error());
  return server;
}

Result<void> HttpServer::Start() {
  auto listener = ListenForVisitors(options_.port, options_.reach, options_.address);
  if (!listener) return tl::unexpected(listener.error());
  // MHD ends a list of options where it finds this one.
  constexpr MHD_OptionItem kEnd{MHD_OPTION_END, 0, nullptr};
  std::array<MHD_OptionItem, 4> secure{kEnd, kEnd, kEnd, kEnd};
  unsigned flags = MHD_USE_EPOLL | MHD_ALLOW_SUSPEND_RESUME;
  if (options_.certificate) {
    flags |= MHD_USE_TLS;
    secure[0] = {MHD_OPTION_HTTPS_MEM_KEY, 0, options_.certificate->key.data()};
    secure[1] = {MHD_OPTION_HTTPS_MEM_CERT, 0, options_.certificate->chain.data()};
    secure[2] = {MHD_OPTION_HTTPS_PRIORITIES, 0, const_cast<char*>(kTlsPriorities)};
  }
  daemon_ = MHD_start_daemon(
      flags, 0, nullptr, nullptr, &Callbacks::Access, this, MHD_OPTION_LISTEN_SOCKET, listener->get(),
      MHD_OPTION_CONNECTION_LIMIT, options_.most_connections + kMoreOfMhd, MHD_OPTION_UNESCAPE_CALLBACK,
      &Callbacks::Decode, nullptr, MHD_OPTION_CONNECTION_TIMEOUT, kIdleTimeout_s, MHD_OPTION_NOTIFY_COMPLETED,
      &Callbacks::Complete, this, MHD_OPTION_NOTIFY_CONNECTION, &Callbacks::Connect, this, MHD_OPTION_ARRAY,
      secure.data(), MHD_OPTION_END);
  if (daemon_ == nullptr && options_.certificate)
    return FailInput("start the web server: its certificate or key is not valid");
  if (daemon_ == nullptr) return Fail(std::errc::io_error, "start the web server");
  (void)listener->release();  // MHD closes it.
  return {};
}

HttpServer::~HttpServer() {
  if (daemon_ == nullptr) return;
  loop_.Forget(pollable());
  for (Feed* feed : feeds_) feed->End();  // MHD must not be stopped while a connection is suspended.
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
  // MHD's own timeout starts anew with each byte.
  connections_.CloseSlow();
  // MHD says that it has more to do at once by a time-out of 0.
  for (int run = 0; run < kRunsAtOnce; ++run) {
    MHD_run(daemon_);
    MHD_UNSIGNED_LONG_LONG wait_ms = 0;
    if (MHD_get_timeout(daemon_, &wait_ms) == MHD_NO || wait_ms > 0) return;
  }
}

MHD_Response* HttpServer::Respond(const Request& request, MHD_Connection* connection, unsigned* status) {
  Answer answer = handler_(request);
  if (Feed* const* feed = std::get_if<Feed*>(&answer)) {
    if (std::ranges::find(feeds_, *feed) == feeds_.end()) feeds_.push_back(*feed);
    Callbacks::ConnectionOf(connection).limit = {};
    return (*feed)->Listen(connection);
  }
  auto& reply = std::get<Reply>(answer);
  *status = reply.status;
  // A file takes as long as it takes, for as long as it is received.
  if (reply.file.valid()) Callbacks::ConnectionOf(connection).limit = {};
  MHD_Response* response =
      reply.file.valid() ? FileResponse(std::move(reply.file), reply.file_name) : TextResponse(reply.body);
  if (response == nullptr) return nullptr;
  MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, reply.content_type.c_str());
  if (!reply.cookie.empty())
    MHD_add_response_header(response, MHD_HTTP_HEADER_SET_COOKIE, reply.cookie.c_str());
  return response;
}

}  // namespace kaori::web
