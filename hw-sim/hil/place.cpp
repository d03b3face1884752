#include "hw-sim/hil/place.h"

#include <poll.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;

constexpr Duration kLookAgain = milliseconds(20);
constexpr Duration kHands = milliseconds(4);  // Slow hands move in steps of this.
constexpr Duration kAskAgain = milliseconds(100);
constexpr Duration kLongestAnswer = std::chrono::seconds(90);

std::string Hands(const BoardView& board) {
  const auto one = [](const StickView& stick) {
    return fmt::format("{} {:.2f} {:.2f}", stick.live ? "live" : "away", stick.x, stick.y);
  };
  return fmt::format("left {}, right {}", one(board.left), one(board.right));
}

}  // namespace

Place::Place(QemuOptions options, std::unique_ptr<sim::UsbRig> rig, const Clock& clock)
    : clock_(clock),
      rig_(std::move(rig)),
      machine_(options, *this),
      witness_(options.folder + "/serial", *this) {}

Result<std::unique_ptr<Place>> Place::Open(QemuOptions options, const Clock& clock) {
  auto rig = sim::UsbRig::Open(options.folder, clock);
  if (!rig) return tl::unexpected(rig.error());
  return std::unique_ptr<Place>(new Place(std::move(options), std::move(*rig), clock));
}

bool Place::Until(const std::function<bool()>& done, Duration longest, int fd) {
  const Time until = clock_.now() + longest;
  const auto wake_at = [&](Time now) {
    return std::min({until, now + (hands_ ? kHands : kLookAgain), rig_->next_due()});
  };
  while (true) {
    if (hands_) hands_(clock_.now());
    rig_->Pump();
    if (done()) return true;
    const Time now = clock_.now();
    if (now >= until) return false;
    const auto wait = std::chrono::ceil<milliseconds>(std::max(wake_at(now) - now, Duration::zero()));
    std::array<pollfd, 2> fds{{{rig_->pollable(), POLLIN, 0}, {fd, POLLIN, 0}}};
    ::poll(fds.data(), fds.size(), static_cast<int>(wait.count()));
  }
}

Result<BoardView> Place::Board() {
  const auto json = witness_.Ask("board", kLongestAnswer);
  if (!json) return tl::unexpected(json.error());
  return ReadBoardView(*json);
}

Result<BoardView> Place::UntilBoard(const std::function<bool(const BoardView&)>& right, Duration longest,
                                    const std::string& what) {
  const Time until = clock_.now() + longest;
  while (true) {
    auto board = Board();
    if (board && right(*board)) return board;
    if (clock_.now() >= until)
      return Fail(std::errc::timed_out,
                  what + " (" + (board ? Hands(*board) : board.error().message()) + ")");
    For(kAskAgain);
  }
}

Result<void> Place::PlugAll() {
  for (const std::string_view name : sim::kUsbSockets)
    if (auto ok = rig_->Plug(name); !ok) return ok;
  return {};
}

Result<void> Place::PullAll() {
  for (const std::string_view name : sim::kUsbSockets)
    if (auto ok = rig_->Unplug(name); !ok) return ok;
  return {};
}

}  // namespace kaori::hil
