#include "hw-sim/console/console.h"

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "drivers/base/log.h"
#include "drivers/base/timer.h"
#include "hw-sim/console/guard.h"
#include "hw-sim/console/input.h"
#include "hw-sim/console/json.h"
#include "hw-sim/console/page.h"

namespace kaori::console {

using web::Reply;
using web::Request;

namespace {

// Twice as often as pictures leave, so that a picture waits for half of its period at most.
constexpr Duration kTick = std::chrono::microseconds(8'333);
// 20 states a second: finer than a person reads, and coarser than the dials' own lamps need.
constexpr Duration kStatePeriod = std::chrono::milliseconds(50);
constexpr Duration kMonitorPeriod = std::chrono::milliseconds(100);
// Silence is broken this often: listeners that went away are noticed only when something is sent.
constexpr Duration kSignOfLife = std::chrono::seconds(1);

constexpr const char* kText = "text/plain; charset=utf-8";

// What a page asks for that is none of ours.
Reply NotFound(const std::string& path) {
  return {404, kText, path + " is not here\n"};
}

}  // namespace

Console::Console(ConsoleOptions options, sim::Rig& rig, EventLoop& loop)
    : options_(std::move(options)),
      rig_(rig),
      loop_(loop),
      values_(options_.labels),
      // A browser that lost the events' connection tries again after 500 ms
      // ("retry", HTML: server-sent events).
      states_("text/event-stream", "retry: 500\n\n"),
      sounds_("application/octet-stream", "") {}

Result<std::unique_ptr<Console>> Console::Open(ConsoleOptions options, sim::Rig& rig, EventLoop& loop) {
  std::unique_ptr<Console> console(new Console(std::move(options), rig, loop));
  auto server = web::HttpServer::Open({.port = console->options_.port,
                                       .address = console->options_.listen,
                                       .guard = GuardFor(console->options_.listen)},
                                      loop, console->clock_, [self = console.get()](const Request& request) {
                                        return self->Answer(request);
                                      });
  if (!server) return tl::unexpected(server.error());
  console->server_ = std::move(*server);
  if (auto ticking = console->StartTicking(); !ticking) return tl::unexpected(ticking.error());
  return console;
}

Console::~Console() {
  if (ticks_.valid()) loop_.Forget(ticks_.get());
}

std::string Console::address() const {
  return fmt::format("http://{}:{}/", HostFor(options_.listen), server_->port());
}

// A timer of our own: EventLoop::Every has no end, and a console may end before its loop.
Result<void> Console::StartTicking() {
  auto ticks = OpenTimer(kTick, kTick, "start the console's timer");
  if (!ticks) return tl::unexpected(ticks.error());
  ticks_ = std::move(*ticks);
  return loop_.Watch(ticks_.get(), [this] { Tick(); });
}

// A late tick is one tick: what is told is how things stand, not what happened.
void Console::Tick() {
  std::uint64_t passed = 0;
  (void)!::read(ticks_.get(), &passed, sizeof(passed));
  const Time now = clock_.now();
  FollowDevices();
  shown_.See(rig_.screen().frames_shown(), now);
  ShowPicture(now);
  ShowMonitor(now);
  PassSoundOn();
  TellState(now);
  // MHD sends what was just published, and closes connections that are too slow.
  server_->Run();
  LetGoAlone();
}

void Console::FollowDevices() {
  values_.Follow(rig_.dial_box(), rig_.keyboard(), sheet_);
  editor_watch_.Follow({.tab_held = rig_.keyboard().held(EditorWatch::kTab),
                        .keyboard_heard = rig_.connected("keyboard"),
                        .screen_drawn = rig_.connected("screen"),
                        .screen_plugged = rig_.plugged("screen")});
}

// Encodes once for all listeners, and only when one of them has room for it.
void Console::ShowPicture(Time now) {
  if (!pictures_.awaited()) return;
  const Duration age = now - picture_at_;
  // Half a tick early is on time: else a rate that divides the tick would lose every other picture.
  if (age + kTick / 2 < FromSeconds(1 / options_.most_pictures_per_s)) return;
  if (rig_.screen().frames_shown() == sent_frame_ && age < kSignOfLife) return;
  const auto jpeg = EncodeLatest();
  if (!jpeg) return;  // The screen is dark: the page keeps its last picture and says so from the state.
  picture_at_ = now;
  sent_frame_ = rig_.screen().frames_shown();
  pictures_.PublishPicture(*jpeg);
}

// A page that is loaded anew asks again within the second. The monitor's clock moves each second, so that listeners
// that went away are noticed.
void Console::ShowMonitor(Time now) {
  sim::MonitorScreen& monitor = rig_.monitor();
  if (monitor_pictures_.listeners() > 0) watched_at_ = now;
  if (now - watched_at_ >= kSignOfLife) return monitor.Unplug();
  if (auto plugged = monitor.Plug(); !plugged) return;
  if (!monitor_pictures_.awaited() || now - monitor_at_ < kMonitorPeriod) return;
  const auto* const rgbx = monitor.Read();
  if (rgbx == nullptr) return;
  const auto jpeg =
      jpeg_.Encode({static_cast<int>(monitor.kWidth_px), static_cast<int>(monitor.kHeight_px), *rgbx},
                   options_.jpeg_quality);
  if (!jpeg) return;
  monitor_at_ = now;
  monitor_pictures_.PublishPicture(*jpeg);
}

// What nobody listens to is forgotten: a page that asks for sound hears what is played from then on.
void Console::PassSoundOn() {
  const auto heard = rig_.loudspeaker().DrainHeard();
  if (sounds_.listeners() == 0) return packets_.Clear();
  packets_.Add(heard);
  if (packets_.ready() && sounds_.awaited()) sounds_.Publish(packets_.Next());
}

// Asks the stage's monitor each time: it looks at its file once a second at most.
std::string Console::StateNow() {
  json::Value on_stage = options_.on_stage ? options_.on_stage() : json::Value();
  if (const auto* said = on_stage.As<json::Object>()) {
    const auto sheet = std::ranges::find(*said, "sheet", &json::Object::value_type::first);
    const auto* number = sheet == said->end() ? nullptr : sheet->second.As<std::int64_t>();
    sheet_ = number != nullptr && *number == 1 ? 1 : 0;
  }
  return StateJson(rig_, values_, editor_watch_, std::move(on_stage), shown_.per_s());
}

// An equal state is told again only as a sign of life.
void Console::TellState(Time now) {
  // A state that nobody can receive now is not built: the next one will say more.
  if (now - state_at_ < kStatePeriod || !states_.awaited()) return;
  auto state = StateNow();
  if (state == state_ && now - state_at_ < kSignOfLife) return;
  state_ = std::move(state);
  state_at_ = now;
  states_.Publish(fmt::format("data: {}\n\n", state_));
}

// Who may ask at all was decided by the server's guard. Three answers are feeds that go on for as long as the
// page listens.
web::HttpServer::Answer Console::Answer(const Request& request) {
  if (request.method == "POST") {
    if (request.path == "/input") return AcceptInput(request.body);
    if (request.path == "/call") return AcceptCalls(request.body);
    return NotFound(request.path);
  }
  if (request.method != "GET" && request.method != "HEAD") return Reply{405, kText, "GET and POST only\n"};
  if (request.path == "/picture") return &pictures_;
  if (request.path == "/monitor") return &monitor_pictures_;
  if (request.path == "/events") return &states_;
  if (request.path == "/frame.jpg") return OnePicture();
  if (request.path == "/sound") return &sounds_;
  if (request.path == "/state") return Reply{200, "application/json", StateNow()};
  if (request.path == "/labels") return Reply{200, "application/json", LabelsJson(options_.labels)};
  if (const auto* file = FindPageFile(request.path))
    return Reply{200, std::string(file->content_type), std::string(file->bytes)};
  return NotFound(request.path);
}

// An action is noted before it is done: one that fails half way is still let go of later.
Reply Console::AcceptInput(const std::string& lines) {
  const auto actions = ReadInput(lines);
  if (!actions) return {400, kText, actions.error().attempt + "\n"};
  for (const auto& action : *actions) held_.Note(action);
  if (auto done = Do(*actions); !done) return {503, kText, done.error().message() + "\n"};
  return {204, kText, {}};
}

// Calls before a wrong one are made: each stands for itself.
Reply Console::AcceptCalls(std::string_view lines) {
  while (!lines.empty()) {
    const auto end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    if (line.empty()) continue;
    const auto called =
        options_.call ? options_.call(line) : Result<void>(FailInput("nobody hears calls here"));
    if (called) continue;
    const bool wrong = called.error().cause == std::errc::invalid_argument;
    return {wrong ? 400U : 503U, kText, called.error().message() + "\n"};
  }
  return {204, kText, {}};
}

Result<void> Console::Do(const std::vector<sim::OperatorAction>& actions) {
  for (const auto& action : actions) {
    if (auto done = rig_.Do(action); !done) return done;
    FollowDevices();  // One message may hold a key's push and its release.
  }
  rig_.Pump();
  return {};
}

// A page that is closed in the middle of a drag lets go of its controls.
void Console::LetGoAlone() {
  if (states_.listeners() > 0) {
    played_ = true;
    return;
  }
  if (!std::exchange(played_, false)) return;
  if (auto done = Do(held_.LetGo()); !done) LogWarning("let go of the devices: {}", done.error().message());
}

Reply Console::OnePicture() {
  auto jpeg = EncodeLatest();
  if (!jpeg) return {503, kText, jpeg.error().message() + "\n"};
  return {200, "image/jpeg", std::move(*jpeg)};
}

Result<std::string> Console::EncodeLatest() {
  const auto shown = rig_.screen().latest();
  if (!shown) return Fail(std::errc::no_message_available, "show the screen: it is dark");
  return jpeg_.Encode({shown->width_px, shown->height_px, shown->rgbx}, options_.jpeg_quality);
}

}  // namespace kaori::console
