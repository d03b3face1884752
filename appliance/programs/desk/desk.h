// The desk: a web page on which the lips are calibrated, before and between shows.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "appliance/programs/desk/lip_connection.h"
#include "appliance/programs/desk/origin_check.h"
#include "appliance/programs/desk/pairing.h"
#include "appliance/programs/desk/state_json.h"
#include "appliance/programs/desk/view.h"
#include "drivers/web/feed.h"
#include "drivers/web/http_server.h"
#include "drivers/web/jpeg.h"

namespace kaori::desk {

struct DeskOptions {
  std::uint16_t port = 8443;  // 0: any free port.
  web::Reach reach = web::Reach::kNetwork;
  std::optional<web::Certificate> certificate{};
  std::uint32_t fingerprint = 0;  // The fingerprint of the certificate; see OwnCertificate.
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

  // Receives from the lips, sends to the pages and renews the code. Call it every 20 ms.
  void Step();

  // The page's address, such as "https://192.168.0.1:8443/".
  std::string address() const;

  const Pairing& pairing() const { return pairing_; }
  std::size_t connections() const { return server_->connections(); }

 private:
  Desk(DeskOptions options, const board::Board& board, board::Writer<board::Desk> writer, const Clock& clock);
  web::HttpServer::Answer Answer(const web::Request& request);
  web::HttpServer::Answer AnswerPaired(const web::Request& request);
  web::Reply Page(const web::Request& request);
  web::Reply Pair(const web::Request& request);
  web::Reply EndSession(const web::Request& request);
  web::Reply ExecuteCommand(const web::Request& request);
  web::Reply Hello(bool paired);
  web::Reply Status();
  web::Feed* FeedOf(const std::string& path);
  std::string State();
  void SendPictures(Time now);
  void SendState(Time now);
  void PublishCode(Time now);

  DeskOptions options_;
  const board::Board& board_;
  board::Writer<board::Desk> writer_;
  const Clock& clock_;
  Pairing pairing_;
  LipConnection lips_;
  web::JpegEncoder jpeg_;
  std::vector<std::uint8_t> composed_;
  std::array<std::unique_ptr<web::Feed>, kViewCount> pictures_;
  std::array<std::uint32_t, kViewCount> sent_{};  // The number of the picture that each feed sent last.
  web::Feed states_;
  std::string state_;
  Time state_at_{};
  Time code_at_{};
  bool dismiss_ = false;  // Feeds are to be closed at the next step.
  std::uint32_t address_ = 0;
  std::unique_ptr<web::HttpServer> server_;
};

}  // namespace kaori::desk
