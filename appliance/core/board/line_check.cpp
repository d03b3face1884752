#include "appliance/core/board/line_check.h"
#include "appliance/core/board/learn.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace kaori::board {
namespace {

// In the order of show::Control and board::Line; what a kind of one item alone is called inside its device is
// nothing.
constexpr std::array<std::string_view, 6> kAxisNames{"x", "y", "twist", "hat x", "hat y", "slider"};
constexpr std::array<std::string_view, 6> kSwitchNames{"GO",       "blackout", "service key",
                                                       "presence", "BACK",     "PANIC"};
constexpr std::array<std::string_view, kCheckedStateCount> kStateNames{
    "not plugged in", "noisy", "stuck", "short way", "not yet seen", "seen"};

template <std::size_t kCount>
std::string_view NameAt(const std::array<std::string_view, kCount>& names, std::uint32_t number) {
  return number < kCount ? names[number] : "unknown";
}

// Of the sticks, which are devices 0 and 1; a dial box is told of with all its dials and buttons together.
bool IsOfStick(const CheckedItem& item) {
  return item.device < 2;
}

bool IsNumbered(const CheckedItem& item) {
  return item.kind == CheckedKind::kDial || (item.kind == CheckedKind::kButton && !IsOfStick(item));
}

// Within its device. Devices of one item are their own name.
std::string PartOf(const CheckedItem& item) {
  switch (item.kind) {
    case CheckedKind::kAxis:
      return std::string(NameAt(kAxisNames, item.number));
    case CheckedKind::kDial:
      return fmt::format("dial {}", item.number + 1);
    case CheckedKind::kButton:
      return fmt::format("button {}", item.number + 1);
    case CheckedKind::kSwitch:
      return std::string(NameAt(kSwitchNames, item.number));
    case CheckedKind::kLamps:
      return "lamps";
    case CheckedKind::kScreen:
      return fmt::format("screen {}", item.number + 1);
    case CheckedKind::kKeyboard:
    case CheckedKind::kCamera:
    case CheckedKind::kMicrophone:
    case CheckedKind::kLoudspeaker:
      break;
  }
  return {};
}

// How it stands. Nobody sees the lamps but a person, who may have forgotten to say so.
std::string StandsAs(const CheckedItem& item) {
  const bool unseen = item.state == CheckedState::kUnseen;
  if (item.kind == CheckedKind::kLamps && unseen) return "nobody has said that all were lit";
  std::string words(NameAt(kStateNames, static_cast<std::uint32_t>(item.state)));
  const bool moved = item.high > item.low && !unseen && item.state != CheckedState::kMissing;
  if (moved && item.kind == CheckedKind::kMicrophone)
    words += fmt::format(", {:.0f} to {:.0f} dB", item.low, item.high);
  else if (moved)
    words += fmt::format(", {:.2f} to {:.2f}", item.low, item.high);
  if (moved && item.low_first != 0) words += ", lower end first";
  return words;
}

// "3-7, 9" of ascending numbers from 0.
std::string Ranges(const std::vector<std::uint32_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    if (!text.empty()) text += ", ";
    text += end - i > 1 ? fmt::format("{}-{}", numbers[i] + 1, numbers[end - 1] + 1)
                        : fmt::format("{}", numbers[i] + 1);
    i = end;
  }
  return text;
}

// Dials and buttons in one state, with their numbers alone; empty where there are none.
std::string Together(std::span<const CheckedItem> items, CheckedKind kind, CheckedState state) {
  std::vector<std::uint32_t> numbers;
  for (const CheckedItem& item : items)
    if (item.kind == kind && IsNumbered(item) && item.state == state) numbers.push_back(item.number);
  if (numbers.empty()) return {};
  const char* const name = kind == CheckedKind::kDial ? "dial" : "button";
  return fmt::format("{}{} {} {}", name, numbers.size() > 1 ? "s" : "", Ranges(numbers),
                     NameAt(kStateNames, static_cast<std::uint32_t>(state)));
}

void Add(std::string& text, const std::string& phrase) {
  if (phrase.empty()) return;
  if (!text.empty()) text += "; ";
  text += phrase;
}

bool IsAllGone(const CheckedItem& item) {
  return item.state == CheckedState::kMissing && item.kind != CheckedKind::kScreen;
}

// The devices that are not plugged in, each once; with their names where all devices are asked for.
std::string Missing(std::span<const CheckedItem> items, std::string_view device) {
  std::string text;
  std::string_view before;
  for (const CheckedItem& item : items) {
    const std::string_view name = DeviceOf(item);
    if (!IsAllGone(item) || name == before || (!device.empty() && name != device)) continue;
    before = name;
    const std::string_view words = NameAt(kStateNames, static_cast<std::uint32_t>(item.state));
    Add(text, device.empty() ? fmt::format("{} {}", name, words) : std::string(words));
  }
  return text;
}

}  // namespace

std::size_t SeenOf(const LineCheck& check) {
  return static_cast<std::size_t>(
      std::ranges::count(ItemsOf(check), CheckedState::kSeen, &CheckedItem::state));
}

std::string_view DeviceOf(const CheckedItem& item) {
  switch (item.kind) {
    case CheckedKind::kAxis:
      return item.device == 0 ? "left stick" : "right stick";
    case CheckedKind::kButton:
      return item.device == 0 ? "left stick" : item.device == 1 ? "right stick" : "dial box";
    case CheckedKind::kDial:
    case CheckedKind::kLamps:
      return "dial box";
    case CheckedKind::kSwitch:
      return "switches";
    case CheckedKind::kKeyboard:
      return "keyboard";
    case CheckedKind::kCamera:
      return "camera";
    case CheckedKind::kMicrophone:
      return "microphone";
    case CheckedKind::kLoudspeaker:
      return "loudspeaker";
    case CheckedKind::kScreen:
      return "screens";
  }
  return "unknown";
}

std::string NameOf(const CheckedItem& control) {
  return fmt::format("{} {}", DeviceOf(control), PartOf(control));
}

std::string PhraseOf(const CheckedItem& item) {
  const std::string part = PartOf(item);
  return part.empty() ? StandsAs(item) : part + " " + StandsAs(item);
}

// A device that is not there is named once, and not each of its controls; screens are devices of their own. A
// range is worth its own phrase; of dials and buttons that nobody has moved, or that only were pushed, the
// number says all.
std::string PhrasesOf(const LineCheck& check, std::string_view device, bool failing) {
  const auto items = ItemsOf(check);
  const bool all = device.empty();
  const bool box = all || device == DeviceOf({.kind = CheckedKind::kDial});
  std::string text = Missing(items, device);
  for (std::uint32_t n = 0; n < kCheckedStateCount; ++n) {
    const auto state = static_cast<CheckedState>(n);
    if (failing && state == CheckedState::kSeen) continue;
    const bool ranges = state == CheckedState::kShort || state == CheckedState::kSeen;
    for (const CheckedItem& item : items) {
      if (item.state != state || IsAllGone(item) || (!all && DeviceOf(item) != device)) continue;
      if (IsNumbered(item) && !(ranges && item.kind == CheckedKind::kDial)) continue;
      const bool named = all && (item.kind == CheckedKind::kAxis || item.kind == CheckedKind::kButton ||
                                 PartOf(item).empty());
      Add(text, named ? std::string(DeviceOf(item)) + " " + PhraseOf(item) : PhraseOf(item));
    }
    if (!box || state == CheckedState::kMissing) continue;
    if (!ranges) Add(text, Together(items, CheckedKind::kDial, state));
    Add(text, Together(items, CheckedKind::kButton, state));
  }
  return text;
}

std::string SummaryOf(const LineCheck& check) {
  const std::size_t seen = SeenOf(check);
  if (seen == check.count) return fmt::format("all {} work", check.count);
  return fmt::format("{} of {} work; {}", seen, check.count, PhrasesOf(check, {}, true));
}

}  // namespace kaori::board
