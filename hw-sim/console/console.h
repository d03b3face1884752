// A page in the browser that plays the simulated devices: dials, sticks, keys, lips, and the picture.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"
#include "drivers/web/feed.h"
#include "drivers/web/http_server.h"
#include "drivers/web/jpeg.h"
#include "hw-sim/console/dial_values.h"
#include "hw-sim/console/editor_watch.h"
#include "hw-sim/console/held.h"
#include "hw-sim/console/json.h"
#include "hw-sim/console/labels.h"
#include "hw-sim/console/rate.h"
#include "hw-sim/console/sound_packets.h"
#include "hw-sim/links/local/rig.h"

namespace kaori::console {

struct ConsoleOptions {
  std::uint16_t port = 0;  // 0: any free one.
  // An IPv4 address of this machine, or 0.0.0.0 for all of them; empty: 127.0.0.1 alone. Whoever reaches it plays.
  std::string listen{};
  Labels labels;
  double most_pictures_per_s = 30;  // Sent to the page; each costs about 3 ms of CPU at 960x540.
  int jpeg_quality = 85;
  // What is on stage; nothing while no stage draws. May be empty: the page then shows none.
  std::function<std::optional<OnStage>()> on_stage{};
};

// Input acts through Rig::Do alone, so as report bytes and camera frames; the console pumps the rig after it, and nobody
// else's pump is in its way. One thread, the loop's.
class Console {
 public:
  // `rig` and `loop` must outlive the console. Errors: address_in_use, those of sockets and timers.
  static Result<std::unique_ptr<Console>> Open(ConsoleOptions options, sim::Rig& rig, EventLoop& loop);
  ~Console();

  // "http://127.0.0.1:8093/". Where it listens on every address, the name of this machine stands there.
  std::string address() const;

 private:
  Console(ConsoleOptions options, sim::Rig& rig, EventLoop& loop);
  Result<void> StartTicking();
  void Tick();
  void ShowPicture(Time now);
  void PassSoundOn();
  void TellState(Time now);
  std::string StateNow();
  web::HttpServer::Answer Answer(const web::Request& request);
  web::Reply AcceptInput(const std::string& lines);
  Result<void> Do(const std::vector<sim::OperatorAction>& actions);
  void LetGoAlone();
  web::Reply OnePicture();
  Result<std::string> EncodeLatest();

  ConsoleOptions options_;
  sim::Rig& rig_;
  EventLoop& loop_;
  SteadyClock clock_;  // The page lives in real time, whatever the rig's clock does.
  web::JpegEncoder jpeg_;
  DialValues values_;
  EditorWatch editor_watch_;
  Rate shown_;                    // Frames the screen has shown.
  std::uint64_t sent_frame_ = 0;  // frames_shown() of the last picture that was sent.
  Time picture_at_{};
  std::string state_;
  Time state_at_{};
  web::Feed pictures_;
  web::Feed states_;
  web::Feed sounds_;
  SoundPackets packets_;
  Held held_;
  bool played_ = false;  // A page listened at the last tick.
  UniqueFd ticks_;
  std::unique_ptr<web::HttpServer> server_;
};

}  // namespace kaori::console
