#include "appliance/core/linecheck/items.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/lines.h"

namespace kaori::linecheck {
namespace {

using board::CheckedItem;
using board::CheckedKind;

// All that there can be: axes of two sticks, dials, buttons, switches, five that are one each, and screens.
static_assert(2 * show::kControlCount + 8 + show::kAllButtonCount + board::kLineCount + 5 + kMostScreens <=
              board::LineCheck::kMostItems);

void Add(board::LineCheck& check, CheckedKind kind, std::uint32_t device, std::size_t number) {
  const auto same = [&](const CheckedItem& item) {
    return item.kind == kind && item.device == device && item.number == number;
  };
  if (std::ranges::any_of(board::ItemsOf(check), same)) return;
  check.items[check.count++] = {.kind = kind, .device = device, .number = static_cast<std::uint32_t>(number)};
}

// In the order of the devices, however the roles stand in their file.
void AddControls(board::LineCheck& check, const show::Roles& roles,
                 std::span<const std::uint8_t> role_devices) {
  for (std::uint8_t number = 0; number < show::kDeviceCount; ++number) {
    const auto device = static_cast<show::Device>(number);
    for (std::size_t role = 0; role < roles.roles.size(); ++role) {
      if (role_devices[role] != number) continue;
      for (const show::RoleMap& map : roles.roles[role].maps) {
        if (!show::Has(device, map.control)) continue;
        if (show::Turns(map.control))
          Add(check, CheckedKind::kDial, number, map.dial);
        else
          Add(check, CheckedKind::kAxis, number, static_cast<std::size_t>(map.control));
      }
    }
  }
  // Dials stand in the order of the roles' maps, which may be any.
  std::ranges::sort(check.items.begin(), check.items.begin() + check.count, {},
                    [](const CheckedItem& item) { return std::pair(item.device, item.number); });
}

void AddButtons(board::LineCheck& check, const show::Show& show) {
  const auto calls = [](const show::Call& call) { return call.kind != show::CallKind::kNothing; };
  bool any = false;
  for (std::size_t i = 0; i < show.buttons.size(); ++i) {
    if (!calls(show.buttons[i]) && !calls(show.second_buttons[i])) continue;
    Add(check, CheckedKind::kButton, static_cast<std::uint32_t>(show::Device::kDialBox), i);
    any = true;
  }
  for (std::size_t i = 0; i < show.stick_buttons.size(); ++i)
    if (calls(show.stick_buttons[i]))
      Add(check, CheckedKind::kButton, static_cast<std::uint32_t>(i / show::kStickButtonCount),
          i % show::kStickButtonCount);
  if (any) Add(check, CheckedKind::kLamps, static_cast<std::uint32_t>(show::Device::kDialBox), 0);
}

}  // namespace

board::LineCheck ItemsFor(const show::Show& show, std::span<const std::uint8_t> role_devices,
                          const board::Snapshot& board, std::size_t screens) {
  board::LineCheck check;
  AddControls(check, show.roles, role_devices);
  AddButtons(check, show);
  for (std::size_t line = 0; line < board::kLineCount; ++line)
    if ((board.lines.value.wired >> line & 1U) != 0) Add(check, CheckedKind::kSwitch, 0, line);
  if (board.keys.source != board::SourceState::kAbsent) Add(check, CheckedKind::kKeyboard, 0, 0);
  Add(check, CheckedKind::kCamera, 0, 0);
  Add(check, CheckedKind::kMicrophone, 0, 0);
  Add(check, CheckedKind::kLoudspeaker, 0, 0);
  for (std::size_t n = 0; n < std::clamp<std::size_t>(screens, 1, kMostScreens); ++n)
    Add(check, CheckedKind::kScreen, 0, n);
  return check;
}

}  // namespace kaori::linecheck
