#include "appliance/core/linecheck/button_finder.h"

#include <algorithm>

#include "appliance/core/show/roles.h"

namespace kaori::linecheck {
namespace {

using board::CheckedItem;
using namespace std::chrono_literals;

constexpr Duration kLooksForButtons = 500ms;
constexpr std::uint32_t kMostPushes = 3;  // Within that time, by a person who makes sure.

constexpr std::size_t kBox = show::kButtonCount, kStick = show::kStickButtonCount;

// Numbered within its device.
CheckedItem ButtonItem(std::size_t button) {
  const show::Device device = button < kBox            ? show::Device::kDialBox
                              : button < kBox + kStick ? show::Device::kLeftStick
                                                       : show::Device::kRightStick;
  return {.kind = board::CheckedKind::kButton,
          .device = static_cast<std::uint32_t>(device),
          .number = static_cast<std::uint32_t>(button < kBox ? button : (button - kBox) % kStick),
          .state = board::CheckedState::kSeen};
}

// How a button stands on the board.
struct ButtonNow {
  std::uint32_t pushes = 0;
  bool is_down = false;
};
ButtonNow NowOf(const board::Snapshot& board, std::size_t button) {
  const auto of = [](const auto& device, std::size_t n) {
    return ButtonNow{device.pushes[n], (device.buttons_down >> n & 1U) != 0};
  };
  if (button < kBox) return of(board.surface.value, button);
  return of(board.sticks[(button - kBox) / kStick].value, (button - kBox) % kStick);
}

}  // namespace

void ButtonFinder::Begin(const board::Snapshot& board, Time now) {
  *this = {};
  changed_at_ = now;
  for (std::size_t n = 0; n < contacts_.size(); ++n) {
    const auto [pushes, is_down] = NowOf(board, n);
    contacts_[n].Begin(pushes, is_down, now);
  }
}

// Buttons that were held when it began are let go without having been pushed: the count of pushes tells, not
// the state. A box that is unplugged lets go of all.
void ButtonFinder::Look(const board::Snapshot& board, Time now) {
  bool pushed = false;
  for (std::size_t n = 0; n < contacts_.size(); ++n) {
    const auto [pushes, is_down] = NowOf(board, n);
    contacts_[n].Follow(pushes, is_down, now);
    noisy_[n] = noisy_[n] || contacts_[n].noisy();
    pushed = pushed || PushesOf(n) != 0;
  }
  if (!decides_at_ && pushed) decides_at_ = now + kLooksForButtons;
  if (decides_at_ && now >= *decides_at_) Decide(now);
}

// One that is about to be known as chattering has been pushed too often already.
void ButtonFinder::Decide(Time now) {
  decides_at_.reset();
  std::size_t count = 0, button = 0;
  for (std::size_t n = 0; n < contacts_.size(); ++n) {
    const std::uint32_t pushes = PushesOf(n);
    if (pushes != 0 && pushes <= kMostPushes) ++count, button = n;
    decided_[n] = contacts_[n].pushes();
  }
  if (count == 0) return;
  changed_at_ = now;
  ambiguous_ = count > 1;
  if (count == 1) found_ = ButtonItem(button);
}

std::optional<CheckedItem> ButtonFinder::restless() const {
  const auto* const noisy = std::ranges::find(noisy_, true);
  if (noisy == noisy_.end()) return std::nullopt;
  return ButtonItem(static_cast<std::size_t>(noisy - noisy_.begin()));
}

}  // namespace kaori::linecheck
