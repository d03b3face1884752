#include "hw-sim/hil/target.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;

// How often whatever is waited for is looked at.
// Most conditions look at a file or a process, which nothing announces: they are asked again.
constexpr Duration kLookAgain = milliseconds(20);
constexpr Duration kInputStep = milliseconds(4);  // Simulated input moves in steps of this.
// A question costs the guest time: asked more often, it would slow down what is measured.
constexpr Duration kAskAgain = milliseconds(100);
// An emulated machine that starts its programs answers slowly.
constexpr Duration kLongestAnswer = std::chrono::seconds(90);

// What most checks wait for: in the message of a wait that was in vain.
std::string DescribeSticks(const BoardView& board) {
  const auto one = [](const StickView& stick) {
    return fmt::format("{} {:.2f} {:.2f}", stick.live ? "live" : "away", stick.x, stick.y);
  };
  return fmt::format("left {}, right {}", one(board.left), one(board.right));
}

// The log is read anew at each look: it is short, and no state can be wrong.
bool HasLine(const std::string& text, std::initializer_list<std::string_view> parts) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (std::ranges::all_of(parts, [&](std::string_view part) { return line.find(part) != line.npos; }))
      return true;
  return false;
}

}  // namespace

Target::Target(QemuOptions options, std::unique_ptr<sim::UsbRig> rig, const Clock& clock)
    : clock_(clock),
      rig_(std::move(rig)),
      machine_(std::move(options), *this),
      agent_(machine_.options().folder + "/serial", *this) {}

// The object stays where it is, since machine and agent keep references to it as their waiter.
Result<std::unique_ptr<Target>> Target::Open(QemuOptions options, const Clock& clock) {
  auto rig = sim::UsbRig::Open(options.folder, clock);
  if (!rig) return tl::unexpected(rig.error());
  return std::unique_ptr<Target>(new Target(std::move(options), std::move(*rig), clock));
}

// Here the bench waits for its machine: devices, operator and the condition have their turns while it does.
bool Target::Until(const std::function<bool()>& done, Duration longest, int fd) {
  const Time until = clock_.now() + longest;
  const auto wake_at = [&](Time now) {
    return std::min({until, now + (input_ ? kInputStep : kLookAgain), rig_->next_due()});
  };
  while (true) {
    // Input first: what is done now leaves with this Pump.
    if (input_) input_(clock_.now());
    rig_->Pump();
    if (done()) return true;
    const Time now = clock_.now();
    if (now >= until) return false;
    // Rounded up: a wait that ends too soon would only be asked again.
    const auto wait = std::chrono::ceil<milliseconds>(std::max(wake_at(now) - now, Duration::zero()));
    // A negative fd is passed over by poll(2).
    std::array<pollfd, 2> fds{{{rig_->pollable(), POLLIN, 0}, {fd, POLLIN, 0}}};
    ::poll(fds.data(), fds.size(), static_cast<int>(wait.count()));
  }
}

Result<BoardView> Target::Board() {
  const auto json = agent_.Ask("board", kLongestAnswer);
  if (!json) return tl::unexpected(json.error());
  return ReadBoardView(*json);
}

Result<void> Target::Await(const std::function<bool()>& right, Duration longest, const std::string& what) {
  const Time until = clock_.now() + std::min(longest, patience_);
  while (!right()) {
    if (clock_.now() >= until) return Fail(std::errc::timed_out, what);
    For(kAskAgain);
  }
  return {};
}

Result<BoardView> Target::UntilBoard(const std::function<bool(const BoardView&)>& right, Duration longest,
                                     const std::string& what) {
  // The last board that was seen is kept for the message.
  Result<BoardView> board = Fail(std::errc::timed_out, what);
  const auto seen = [&] {
    board = Board();
    return board && right(*board);
  };
  if (Await(seen, longest, what)) return board;
  // What is seen of the sticks helps to tell a dead box from a wrong one.
  return Fail(std::errc::timed_out,
              what + " (" + (board ? DescribeSticks(*board) : board.error().message()) + ")");
}

Result<void> Target::AwaitFrame(Duration longest, const std::string& what) {
  const auto now = Board();
  if (!now) return tl::unexpected(now.error());
  const auto draws = [&](const BoardView& board) {
    return board.stage.live && board.stage.read_ns > now->now_ns;
  };
  const auto drawn = UntilBoard(draws, longest, what);
  return drawn ? Result<void>{} : tl::unexpected(drawn.error());
}

// The wait ends early where the machine ends: its log does not grow any more.
bool Target::UntilConsole(std::initializer_list<std::string_view> parts, Duration longest) {
  const auto said = [&] { return HasLine(machine_.console(), parts); };
  return Until([&] { return said() || !machine_.runs(); }, longest) && said();
}

// The service manager's line is not always there: it writes over it where it counts the seconds of a start.
bool Target::UntilFirstPicture(Duration longest) {
  const auto said = [&] {
    const std::string console = machine_.console();
    return HasLine(console, {kFirstPicture}) || HasLine(console, {"Started ", "kaori-stage"});
  };
  return Until([&] { return said() || !machine_.runs(); }, longest) && said();
}

// The order is that of the sockets, and so of the ports of QEMU's controller.
Result<void> Target::PlugAll() {
  for (const std::string_view name : sim::kUsbSockets)
    if (auto ok = rig_->Plug(name); !ok) return ok;
  return {};
}

Result<void> Target::PullAll() {
  for (const std::string_view name : sim::kUsbSockets)
    if (auto ok = rig_->Unplug(name); !ok) return ok;
  return {};
}

}  // namespace kaori::hil
