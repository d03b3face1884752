// A page in the browser that plays the simulated devices: dials, sticks, keys, lips, and the picture.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
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

// How a page is served and what it says. The labels come from the show;
// without them controls have numbers.
struct ConsoleOptions {
  std::uint16_t port = 0;  // 0: any free one.
  // An IPv4 address of this machine, or 0.0.0.0 for all of them; empty: 127.0.0.1 alone. Whoever reaches it
  // plays.
  std::string listen{};
  Labels labels;
  // Sent to the page; each costs about 3 ms of CPU at 960x540, which the stage
  // of the same machine lacks then.
  double most_pictures_per_s = 30;
  // libjpeg's scale, 1 to 100: above 85 a picture grows faster than it gains.
  int jpeg_quality = 85;
  // What is on stage, as sim::StageMonitor says it, or null. May be empty: the page then shows none.
  std::function<json::Value()> on_stage{};
  // Makes the call that a line of a page says, as "goto 14". May be empty: no page calls anything then.
  // Errors: invalid_argument (no such call), those of the way to the box.
  std::function<Result<void>(std::string_view)> call{};
};

// Input acts through Rig::Do alone, so as report bytes and camera frames; the console pumps the rig
// after it, and nobody else's pump is in its way. Several pages may be open: all see the same state, and
// what one does the others see. One thread, the loop's.
class Console {
 public:
  // Listens, joins the loop and answers from then on. `rig` and `loop` must outlive the console. Errors:
  // address_in_use, those of sockets and timers.
  static Result<std::unique_ptr<Console>> Open(ConsoleOptions options, sim::Rig& rig, EventLoop& loop);
  ~Console();

  // "http://127.0.0.1:8093/". Where it listens on every address, the name of this machine stands there.
  std::string address() const;

 private:
  Console(ConsoleOptions options, sim::Rig& rig, EventLoop& loop);
  // Starts the tick that drives pictures, sound and state. Errors: those of
  // timerfd_create(2) and of EventLoop::Watch.
  Result<void> StartTicking();
  // Looks at everything once and sends what is due.
  void Tick();
  // Looks at what the devices do now: what fills a dial, and whether the needles were opened.
  void FollowDevices();
  // Sends the newest picture where a page has room for it and its time has come.
  void ShowPicture(Time now);
  // Shows the operators' monitor while a page looks at it, and has it drawn no longer than that.
  void ShowMonitor(Time now);
  // Sends what the loudspeaker has played since the last tick.
  void PassSoundOn();
  // Sends the state where it differs from the last one, or a second has passed.
  void TellState(Time now);
  // What the page shows of the devices, as StateJson has it. Remembers which sheet the stage says that the
  // buttons have.
  std::string StateNow();
  // Answers one request; a path that is not known gets 404, another method
  // than GET, HEAD and POST gets 405.
  web::HttpServer::Answer Answer(const web::Request& request);
  // Does what a page sent, all of it or nothing. 400 with the fault of the first
  // wrong line, 503 where a cable fails.
  web::Reply AcceptInput(const std::string& lines);
  // Makes the calls that a page sent, one a line. 400 with the fault of the first wrong line, 503 where no
  // box hears.
  web::Reply AcceptCalls(std::string_view lines);
  // Does the actions in their order and pumps once. Errors: those of Rig::Do.
  Result<void> Do(const std::vector<sim::OperatorAction>& actions);
  // Lets go of what the last page held, once that page has left.
  void LetGoAlone();
  web::Reply OnePicture();
  // The screen as JPEG. Errors: no_message_available (it is dark), those of JpegEncoder.
  Result<std::string> EncodeLatest();

  ConsoleOptions options_;
  sim::Rig& rig_;
  EventLoop& loop_;
  SteadyClock clock_;  // The page lives in real time, whatever the rig's clock does.
  web::JpegEncoder jpeg_;
  DialValues values_;
  std::size_t sheet_ = 0;
  EditorWatch editor_watch_;
  Rate shown_;                    // Frames the screen has shown.
  std::uint64_t sent_frame_ = 0;  // frames_shown() of the last picture that was sent.
  // When the last picture and the last state were sent.
  Time picture_at_{};
  // The state that was sent last: an equal one is not sent again, but for the sign of life.
  std::string state_;
  Time state_at_{};
  web::PictureFeed pictures_, monitor_pictures_;
  Time monitor_at_{};  // When its last picture was sent,
  Time watched_at_{};  // and when a page last looked.
  web::Feed states_;
  web::Feed sounds_;
  SoundPackets packets_;
  // What pages hold down; let go when the last one leaves.
  Held held_;
  bool played_ = false;  // A page listened at the last tick.
  UniqueFd ticks_;
  // Ends first: its handlers use all the others.
  std::unique_ptr<web::HttpServer> server_;
};

}  // namespace kaori::console
