// The desk: a web page on which the lips are calibrated, shows are taken and settings are seen and changed, before and between
// shows. It is a program of its own, since it talks to browsers of any visitor: whatever happens to it, stage, input and lips
// go on.
//
//   GET  /hello                 {"paired": bool}; shows the code where not paired
//   POST /pair                  body: the six digits; 204 and a cookie, 403, or 429
//   POST /do                    body: a command of lips/protocol without its number; {"number": n}
//   GET  /box, /box/events      the box's list and settings (shows/protocol), once or as an event stream
//   POST /box                   body: a request of shows/protocol; 204, 400 for none, 503 while kaori-shows is away
//   GET  /backup                the backup that was made last, as a file
//   POST /brought/BYTE          body: the part that begins at this byte of a backup that is brought; 204, 409 for another one, 507
//                               without room; "restore NAME" to /box then hands it on
//   POST /leave                 ends the session
//   GET  /state, /events        state_json.h, once or as an event stream
//   GET  /picture[/both|/mask]  the camera's picture as a stream of JPEG (multipart/x-mixed-replace)
//   GET  /status.png            the status display
//   GET  everything else        the files of the page, where there is one of this path
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/desk/box_connection.h"
#include "appliance/programs/desk/brought_file.h"
#include "appliance/programs/desk/lip_connection.h"
#include "appliance/programs/desk/origin_check.h"
#include "appliance/programs/desk/pairing.h"
#include "appliance/programs/desk/state_json.h"
#include "appliance/programs/desk/view.h"
#include "drivers/web/feed.h"
#include "drivers/web/http_server.h"
#include "drivers/web/jpeg.h"

namespace kaori::desk {

// In front of the byte at which a part begins that a visitor brings.
inline constexpr std::string_view kBroughtPath = "/brought/";

// Without a certificate the desk serves plain HTTP, which is for tests.
struct DeskOptions {
  // 0 stands for any free port; Desk::address() then tells it.
  std::uint16_t port = 8443;
  web::Reach reach = web::Reach::kNetwork;
  std::optional<web::Certificate> certificate{};
  // The fingerprint of the certificate; see OwnCertificate.
  std::uint32_t fingerprint = 0;
  // Where kaori-shows listens; empty: the page says that it is away.
  std::string shows{};
  // Where a backup lies while a visitor brings it; empty: none can be brought.
  std::filesystem::path brought{};
};

// Every visitor gets the page; only one who typed the code on the box's screen sees pictures or changes
// anything. Used by the loop's thread.
class Desk {
 public:
  // `board`, `loop` and `clock` must outlive the desk. Errors:
  //   address_in_use           another program listens on the port
  //   invalid_argument         the certificate is not valid
  //   device_or_resource_busy  another desk is open on this board
  static Result<std::unique_ptr<Desk>> Open(DeskOptions options, const board::Board& board, EventLoop& loop,
                                            const Clock& clock);

  // Receives from the lips, sends to the pages and renews the code. Call it every 20 ms. It never blocks:
  // sockets are non-blocking, and a browser that does not read loses pictures, not its turn.
  void Step();

  // The page's address, such as "https://192.168.0.1:8443/".
  std::string address() const;

  // For tests, which read the code from it.
  const Pairing& pairing() const { return pairing_; }
  // Open connections of browsers, of 64 at most and 24 from one address.
  std::size_t connections() const { return server_->connections(); }

 private:
  Desk(DeskOptions options, const board::Board& board, board::Writer<board::Desk> writer, const Clock& clock);
  // Answers any request that the guard let through; AnswerPaired those of a visitor who has a session.
  web::HttpServer::Answer Answer(const web::Request& request);
  web::HttpServer::Answer AnswerPaired(const web::Request& request);
  // A file of the page, in the visitor's language.
  web::Reply Page(const web::Request& request);
  // Tries the code in the body, and sets the cookie of a new session.
  web::Reply Pair(const web::Request& request);
  // Ends the visitor's session and takes the cookie away.
  web::Reply EndSession(const web::Request& request);
  // Hands a command on to the lips; 400 for one that is none, 503 where the lips are gone.
  web::Reply ExecuteCommand(const web::Request& request);
  // The state of the box's list and settings, and what a visitor wants of it.
  web::Reply Box() const;
  web::Reply AskBox(const web::Request& request);
  // A backup that goes out, and the parts of one that comes in.
  web::Reply Backup() const;
  web::Reply AcceptPart(const web::Request& request);
  // Says whether the visitor is paired, and shows the code to one who is not.
  web::Reply Hello(bool paired);
  web::Reply Status();
  // The endless answer that belongs to a path; null where there is none.
  web::Feed* FeedOf(const std::string& path);
  // The state of lips and stage as JSON (state_json.h).
  std::string State();
  // Each sends to its feeds what is due, and nothing where nobody listens.
  void SendPictures(Time now);
  void SendState(Time now);
  void SendBox(Time now);
  // Writes the section `desk`, for the stage to show.
  void PublishCode(Time now);

  DeskOptions options_;
  const board::Board& board_;
  board::Writer<board::Desk> writer_;
  const Clock& clock_;
  Pairing pairing_;
  LipConnection lips_;
  BoxConnection box_;
  BroughtFile brought_;
  web::JpegEncoder jpeg_;
  // The view that is being encoded; reused from picture to picture.
  std::vector<std::uint8_t> composed_;
  std::array<web::PictureFeed, kViewCount> pictures_;
  // The number of the picture that each feed sent last.
  std::array<std::uint32_t, kViewCount> sent_{};
  web::Feed states_;
  // The same of the box, and what was sent of it last.
  web::Feed boxes_;
  std::string box_state_;
  Time box_at_{};
  // The state that was sent last, when, and when the code was written last.
  std::string state_;
  Time state_at_{};
  Time code_at_{};
  // Feeds are to be closed at the next step: a session has ended, and its feeds cannot be told apart from
  // those of others, so that all are closed and the pages of the rest connect again.
  bool dismiss_ = false;
  // IPv4 of the page's address, 0xC0A80001 for 192.168.0.1.
  std::uint32_t address_ = 0;
  // Last: its connections use all the others.
  std::unique_ptr<web::HttpServer> server_;
};

}  // namespace kaori::desk
