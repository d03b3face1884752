#include "appliance/programs/desk/desk.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "appliance/programs/desk/page.h"
#include "appliance/programs/desk/status_png.h"
#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/log.h"

namespace kaori::desk {
namespace {

using web::Reply;
using web::Request;

// A page draws the mouth from the states: 16 a second look continuous.
constexpr Duration kStatePeriod = std::chrono::milliseconds(60);
// An unchanged state is sent this often, since listeners that are gone are noticed only when something is
// sent.
constexpr Duration kKeepAlive = std::chrono::seconds(1);
// How often the section is written anew where nothing has changed.
constexpr Duration kCodePeriod = std::chrono::seconds(1);
// Of the JPEG, 0 to 100: paint and skin stay apart.
constexpr int kQuality = 80;

constexpr const char* kText = "text/plain; charset=utf-8";
constexpr const char* kJson = "application/json";
constexpr const char* kEvents = "text/event-stream";
constexpr const char* kReconnect = "retry: 500\n\n";
constexpr std::string_view kCookie = "kaori-desk=";
constexpr std::array<std::string_view, kViewCount> kPicturePaths{"/picture", "/picture/both",
                                                                 "/picture/mask"};

// The session in a Cookie header, empty where there is none. A cookie whose name only ends like ours is
// another one.
std::string SessionIn(std::string_view cookies) {
  std::size_t at = cookies.find(kCookie);
  while (at != std::string_view::npos && at > 0 && cookies[at - 1] != ' ' && cookies[at - 1] != ';')
    at = cookies.find(kCookie, at + 1);
  if (at == std::string_view::npos) return {};
  cookies.remove_prefix(at + kCookie.size());
  return std::string(cookies.substr(0, cookies.find(';')));
}

// HttpOnly keeps scripts from it, SameSite=Strict other sites, and Secure plain HTTP.
std::string CookieOf(const std::string& session, bool secure) {
  return fmt::format("{}{}; Path=/; HttpOnly; SameSite=Strict{}", kCookie, session, secure ? "; Secure" : "");
}

Reply NotFound(const std::string& path) {
  return {404, kText, "there is no " + path + "\n"};
}

}  // namespace

// The address is asked once: a desk on a box that gets another address has to be started anew.
Desk::Desk(DeskOptions options, const board::Board& board, board::Writer<board::Desk> writer,
           const Clock& clock)
    : options_(std::move(options)),
      board_(board),
      writer_(std::move(writer)),
      clock_(clock),
      pairing_(clock),
      lips_(lips::ServicePath(board.path())),
      box_(options_.shows),
      brought_(options_.brought),
      states_(kEvents, kReconnect),
      boxes_(kEvents, kReconnect) {
  address_ = options_.reach == web::Reach::kNetwork ? OwnAddress() : 0x7F000001U;
}

// The section is acquired first, so that a second desk on one board fails before it takes a port. The server
// calls back into the desk, which therefore lies on the heap and does not move.
Result<std::unique_ptr<Desk>> Desk::Open(DeskOptions options, const board::Board& board, EventLoop& loop,
                                         const Clock& clock) {
  auto writer = board.AcquireWriter<board::Desk>();
  if (!writer) return tl::unexpected(writer.error());
  const bool secure = options.certificate.has_value();
  std::unique_ptr<Desk> desk(new Desk(std::move(options), board, std::move(*writer), clock));
  auto server = web::HttpServer::Open(
      {.port = desk->options_.port,
       .reach = desk->options_.reach,
       .certificate = desk->options_.certificate,
       .most_body_bytes = shows::kLongestRequest_bytes,
       .guard = [rules =
                     OriginRules{OwnNames(), secure}](const web::Visitor& v) { return Refusal(v, rules); }},
      loop, clock, [self = desk.get()](const Request& request) { return self->Answer(request); });
  if (!server) return tl::unexpected(server.error());
  desk->server_ = std::move(*server);
  return desk;
}

// Four numbers and no name: the highest byte of the address comes first.
std::string Desk::address() const {
  return fmt::format("{}://{}.{}.{}.{}:{}/", options_.certificate ? "https" : "http", address_ >> 24,
                     address_ >> 16 & 255U, address_ >> 8 & 255U, address_ & 255U, server_->port());
}

// Feeds are dismissed here, between two runs of the server, and never from within a request that it is
// handling.
void Desk::Step() {
  const Time now = clock_.now();
  lips_.Step(now);
  box_.Step(now);
  if (std::exchange(dismiss_, false)) {
    for (auto& feed : pictures_) feed.Dismiss();
    states_.Dismiss();
    boxes_.Dismiss();
  }
  SendPictures(now);
  SendState(now);
  SendBox(now);
  PublishCode(now);
  server_->Run();
}

// The lips draw pictures only while a paired page shows them; each view is encoded once for all listeners.
void Desk::SendPictures(Time now) {
  const bool looked_at =
      std::ranges::any_of(pictures_, [](const auto& feed) { return feed.listeners() > 0; });
  if (looked_at && pairing_.sessions() > 0) lips_.RequestPictures(now);
  const LipConnection::Picture& picture = lips_.picture();
  for (std::size_t view = 0; view < kViewCount; ++view) {
    if (!pictures_[view].awaited() || sent_[view] == picture.number) continue;
    sent_[view] = picture.number;
    Compose(static_cast<View>(view), picture.rgbp, composed_);
    const auto jpeg = jpeg_.Encode({picture.width_px, picture.height_px, composed_, false}, kQuality);
    if (jpeg) pictures_[view].PublishPicture(*jpeg);
  }
}

// The text is compared, and not the values: what the page would draw alike is not sent again.
void Desk::SendState(Time now) {
  if (now - state_at_ < kStatePeriod || !states_.awaited()) return;
  auto state = State();
  if (state == state_ && now - state_at_ < kKeepAlive) return;
  state_ = std::move(state);
  state_at_ = now;
  states_.Publish(fmt::format("data: {}\n\n", state_));
}

std::string Desk::State() {
  return StateJson({.lips = board_.Read<board::Lips>(),
                    .stage = board_.Read<board::StageStatus>(),
                    .report = lips_.report(),
                    .picture = lips_.picture().number,
                    .now = clock_.now()});
}

// Written anew each second, so that the stage sees when the desk is gone.
void Desk::PublishCode(Time now) {
  const std::size_t sessions = pairing_.sessions();
  const bool changed = pairing_.Step();
  if (pairing_.sessions() < sessions) dismiss_ = true;
  if (!changed && now - code_at_ < kCodePeriod) return;
  code_at_ = now;
  if (!pairing_.shown()) return writer_.Write({}, now, board::SourceState::kAbsent);
  writer_.Write({.code = pairing_.code(),
                 .valid_s = static_cast<float>(Seconds(pairing_.valid())),
                 .address = address_,
                 .port = server_->port(),
                 .secure = options_.certificate ? 1U : 0U,
                 .certificate = options_.fingerprint},
                now, board::SourceState::kLive);
}

// Called by the server within Step, after the guard (origin_check.h). Before a visitor is paired there are
// three things to have: the page's own files, /hello, and /pair.
web::HttpServer::Answer Desk::Answer(const Request& request) {
  const bool posts = request.method == "POST";
  if (!posts && request.method != "GET" && request.method != "HEAD")
    return Reply{405, kText, "only GET, HEAD and POST are allowed\n"};
  if (posts && request.path == "/pair") return Pair(request);
  const bool paired = pairing_.Knows(SessionIn(request.cookie));
  if (!posts && request.path == "/hello") return Hello(paired);
  if (!posts && FindPageFile(request.path) != nullptr) return Page(request);
  if (!paired) return Reply{401, kText, "type the code on the box's screen first\n"};
  return AnswerPaired(request);
}

// What is read comes by GET and what is done by POST, for which the guard wants an Origin.
web::HttpServer::Answer Desk::AnswerPaired(const Request& request) {
  if (request.method == "POST") {
    if (request.path == "/do") return ExecuteCommand(request);
    if (request.path == "/box") return AskBox(request);
    if (request.path.starts_with(kBroughtPath)) return AcceptPart(request);
    if (request.path == "/leave") return EndSession(request);
    return NotFound(request.path);
  }
  if (request.path == "/state") return Reply{200, kJson, State()};
  if (request.path == "/box") return Box();
  if (request.path == "/backup") return Backup();
  if (request.path == "/status.png") return Status();
  if (web::Feed* feed = FeedOf(request.path)) return feed;
  return NotFound(request.path);
}

// 503: nothing that the visitor has done wrong.
Reply Desk::Status() {
  auto png = StatusPng(board_, clock_.now());
  if (!png) return {503, kText, png.error().message() + "\n"};
  return {200, "image/png", std::move(*png)};
}

// Null for any other path.
web::Feed* Desk::FeedOf(const std::string& path) {
  if (path == "/events") return &states_;
  if (path == "/box/events") return &boxes_;
  const auto* at = std::ranges::find(kPicturePaths, path);
  return at == kPicturePaths.end() ? nullptr
                                   : &pictures_[static_cast<std::size_t>(at - kPicturePaths.begin())];
}

// The page has the visitor's language from the first letter on.
Reply Desk::Page(const Request& request) {
  const web::PageFile& file = *FindPageFile(request.path);
  Reply reply{200, std::string(file.content_type), std::string(file.bytes)};
  constexpr std::string_view kEnglish = "<html lang=\"en\">";
  const auto at = reply.body.find(kEnglish);
  if (at != std::string::npos && PrefersJapanese(request.languages))
    reply.body.replace(at, kEnglish.size(), "<html lang=\"ja\">");
  return reply;
}

// A page that is opened makes the box show its code again, for as long as Pairing says.
Reply Desk::Hello(bool paired) {
  if (!paired) pairing_.RequestCode();
  return {200, kJson, fmt::format("{{\"paired\":{}}}\n", paired)};
}

// The answers are the page's protocol: 204 with a cookie, 403 for a wrong code, 429 while all codes are
// refused.
Reply Desk::Pair(const Request& request) {
  std::string session;
  switch (pairing_.Try(request.body, session)) {
    case Verdict::kAccepted:
      Log("a visitor was authorised");
      return {204, kText, {}, CookieOf(session, options_.certificate.has_value())};
    case Verdict::kLocked:
      return {429, kText, "five codes were wrong; wait a minute\n"};
    case Verdict::kWrongCode:
      break;
  }
  LogWarning("a visitor typed a wrong code");
  return {403, kText, "the code is wrong\n"};
}

// All feeds are closed; the pages of other sessions connect again by themselves.
Reply Desk::EndSession(const Request& request) {
  pairing_.EndSession(SessionIn(request.cookie));
  dismiss_ = true;
  return {204, kText, {}, CookieOf("", options_.certificate.has_value()) + "; Max-Age=0"};
}

// The body is a command of the lips' protocol without its number (lips/protocol). Pictures are asked for and
// given back by the desk alone, so that a page cannot use up the slots.
Reply Desk::ExecuteCommand(const Request& request) {
  const auto command = lips::ParseCommand("0 " + request.body);
  if (!command) return {400, kText, command.error().message() + "\n"};
  if (command->kind == lips::CommandKind::kLook || command->kind == lips::CommandKind::kReturn)
    return {400, kText, "only the desk itself sends this command\n"};
  const auto number = lips_.Send(*command);
  if (!number) return {503, kText, "the lip program does not answer\n"};
  return {200, kJson, fmt::format("{{\"number\":{}}}\n", *number)};
}

}  // namespace kaori::desk
