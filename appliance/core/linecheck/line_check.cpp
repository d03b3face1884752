#include "appliance/core/linecheck/line_check.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/board/mouth.h"
#include "appliance/core/linecheck/reading.h"

namespace kaori::linecheck {
namespace {

using board::CheckedItem;
using board::CheckedKind;
using board::CheckedState;
using board::SourceState;
using namespace std::chrono_literals;

constexpr float kOffMiddle = 0.3F;  // What springs back and rests further out than this is stuck.
// Of lips between shut and open. Paint is not measured to the last tenth.
constexpr float kShut = 0.2F, kOpen = 0.8F;
constexpr Duration kStuck = 10s;  // Nobody holds a control for so long without a movement.
constexpr Duration kStill = 1s;   // A camera or a microphone whose counter stands for so long says nothing.
constexpr Duration kNeverQuiet = 15s;  // Longer than anybody speaks in one breath.
constexpr std::uint32_t kMostXruns = 5;
constexpr Duration kLampTime = 200ms;

// Of a button: those of the sticks have no lamps.
bool IsOfStick(const CheckedItem& item) {
  return item.device < static_cast<std::uint32_t>(show::Device::kDialBox);
}

SourceState SourceOf(const CheckedItem& item, const View& view) {
  switch (item.kind) {
    case CheckedKind::kAxis:
    case CheckedKind::kDial:
      return SourceOfWay(item, view.board);
    case CheckedKind::kButton:
      return IsOfStick(item) ? view.board.sticks[item.device].source : view.board.surface.source;
    case CheckedKind::kLamps:
      return view.board.surface.source;
    case CheckedKind::kSwitch:
      return view.board.lines.source;
    case CheckedKind::kKeyboard:
      return view.board.keys.source;
    case CheckedKind::kCamera:
      return view.board.lips.source;
    case CheckedKind::kMicrophone:
      return view.board.voice.source;
    case CheckedKind::kLoudspeaker:
      return view.sound.source;
    case CheckedKind::kScreen:
      return (view.screens >> item.number & 1U) != 0 ? SourceState::kLive : SourceState::kAbsent;
  }
  return SourceState::kAbsent;
}

struct ContactNow {
  std::uint32_t pushes = 0;
  bool down = false;
};

// The keyboard is one contact: any key will do.
ContactNow ContactOf(const CheckedItem& item, const View& view) {
  if (item.kind == CheckedKind::kButton && IsOfStick(item)) {
    const board::Stick& stick = view.board.sticks[item.device].value;
    return {stick.pushes[item.number], (stick.buttons_down >> item.number & 1U) != 0};
  }
  if (item.kind == CheckedKind::kButton) {
    const board::Surface& surface = view.board.surface.value;
    return {surface.pushes[item.number], (surface.buttons_down >> item.number & 1U) != 0};
  }
  if (item.kind == CheckedKind::kSwitch) {
    const board::Lines& lines = view.board.lines.value;
    return {lines.pushes[item.number], board::IsOn(lines, static_cast<board::Line>(item.number))};
  }
  const board::Keys& keys = view.board.keys.value;
  return {keys.log.count, std::ranges::any_of(keys.down, [](std::uint32_t word) { return word != 0; })};
}

// A switch that stays where it is put may be on all evening; those that call something are pushed and let go.
bool StaysDown(const CheckedItem& item) {
  return item.kind == CheckedKind::kSwitch && !board::CueCallOf(static_cast<board::Line>(item.number));
}

bool IsServiceKey(const CheckedItem& item) {
  return item.kind == CheckedKind::kSwitch &&
         item.number == static_cast<std::uint32_t>(board::Line::kService);
}

}  // namespace

void LineCheck::Begin(const board::LineCheck& items, const View& view, Time now) {
  result_ = items;
  result_.phase = board::LineCheckPhase::kRunning;
  began_at_ = changed_at_ = now;
  counts_ = view.board.surface.value.counts;
  for (std::uint32_t i = 0; i < result_.count; ++i) {
    memories_[i] = {};
    BeginItem(result_.items[i], memories_[i], view, now);
  }
  Look(view, now);
}

// Where each stands now is no movement.
void LineCheck::BeginItem(const CheckedItem& item, Memory& memory, const View& view, Time now) const {
  memory.quiet_at = now;
  memory.xruns = view.sound.value.xruns;
  if (item.kind == CheckedKind::kAxis || item.kind == CheckedKind::kDial)
    memory.way.Begin(WayNow(item, view.board, counts_), now);
  if (item.kind == CheckedKind::kCamera) {
    memory.way.Begin(board::PositionOf(view.board.lips.value).open, now);
    memory.pulse.Begin(view.board.lips.value.frames, now);
  }
  if (item.kind == CheckedKind::kMicrophone) {
    memory.way.Begin(view.board.voice.value.level_db, now);
    memory.pulse.Begin(view.board.voice.value.blocks, now);
  }
  const ContactNow contact = ContactOf(item, view);
  memory.contact.Begin(contact.pushes, contact.down, now);
}

void LineCheck::Look(const View& view, Time now) {
  for (std::uint32_t i = 0; i < result_.count; ++i) {
    CheckedItem& item = result_.items[i];
    const bool there = SourceOf(item, view) == SourceState::kLive;
    const CheckedState state = there ? StateOf(item, memories_[i], view, now) : CheckedState::kMissing;
    if (state != item.state) changed_at_ = now;
    item.state = state;
  }
}

CheckedState LineCheck::StateOf(CheckedItem& item, Memory& memory, const View& view, Time now) const {
  switch (item.kind) {
    case CheckedKind::kAxis:
    case CheckedKind::kDial:
      return StateOfWay(item, memory, view, now);
    case CheckedKind::kButton:
    case CheckedKind::kSwitch:
    case CheckedKind::kKeyboard:
      return StateOfContact(item, memory, view, now);
    case CheckedKind::kCamera:
      return StateOfCamera(item, memory, view, now);
    case CheckedKind::kMicrophone:
      return StateOfVoice(item, memory, view, now);
    case CheckedKind::kLoudspeaker:
      return StateOfSound(memory, view);
    case CheckedKind::kLamps:
      return memory.heard ? CheckedState::kSeen : CheckedState::kUnseen;
    case CheckedKind::kScreen:
      return CheckedState::kSeen;
  }
  return CheckedState::kUnseen;
}

CheckedState LineCheck::StateOfWay(CheckedItem& item, Memory& memory, const View& view, Time now) const {
  Way& way = memory.way;
  const float at = WayNow(item, view.board, counts_);
  way.Follow(at, EndsOf(item, view.board), now);
  item.low = way.low();
  item.high = way.high();
  const bool slides = item.kind == CheckedKind::kAxis && show::StaysPut(ControlOf(item));
  const bool springs = item.kind == CheckedKind::kAxis && !slides;
  // A slider may have stood at that end from the beginning.
  item.low_first = way.low_first() && !slides ? 1 : 0;
  if (way.noisy()) return CheckedState::kNoisy;
  if (springs && std::abs(at) > kOffMiddle && way.rests(now) >= kStuck) return CheckedState::kStuck;
  if (way.reached_both()) return CheckedState::kSeen;
  return way.moved() ? CheckedState::kShort : CheckedState::kUnseen;
}

// The service key is on for as long as the check runs, which is all that can be asked of it.
CheckedState LineCheck::StateOfContact(const CheckedItem& item, Memory& memory, const View& view,
                                       Time now) const {
  const ContactNow contact = ContactOf(item, view);
  memory.contact.Follow(contact.pushes, contact.down, now);
  if (memory.contact.noisy()) return CheckedState::kNoisy;
  if (!StaysDown(item) && memory.contact.held(now) >= kStuck) return CheckedState::kStuck;
  return memory.contact.used() || IsServiceKey(item) ? CheckedState::kSeen : CheckedState::kUnseen;
}

// A mouth that is not found is no movement of it.
CheckedState LineCheck::StateOfCamera(CheckedItem& item, Memory& memory, const View& view, Time now) const {
  const board::Lips& lips = view.board.lips.value;
  memory.pulse.Follow(lips.frames, now);
  if (memory.pulse.stands(now) >= kStill) return CheckedState::kStuck;
  if (board::IsUsable(lips)) {
    const float open = board::PositionOf(lips).open;
    if (!memory.heard) memory.way.Begin(open, now);
    memory.heard = true;
    memory.way.Follow(open, {kShut, kOpen}, now);
    item.low = memory.way.low();
    item.high = memory.way.high();
  }
  if (memory.heard && memory.way.reached_both()) return CheckedState::kSeen;
  return memory.heard && memory.way.moved() ? CheckedState::kShort : CheckedState::kUnseen;
}

CheckedState LineCheck::StateOfVoice(CheckedItem& item, Memory& memory, const View& view, Time now) const {
  const board::Voice& voice = view.board.voice.value;
  memory.pulse.Follow(voice.blocks, now);
  memory.way.Follow(voice.level_db, {}, now);
  item.low = memory.way.low();
  item.high = memory.way.high();
  if (memory.pulse.stands(now) >= kStill) return CheckedState::kStuck;
  if (voice.speaking == 0)
    memory.quiet_at = now;
  else
    memory.heard = true;
  if (now - memory.quiet_at >= kNeverQuiet) return CheckedState::kNoisy;
  return memory.heard ? CheckedState::kSeen : CheckedState::kUnseen;
}

// That a voice went to the loudspeaker is all that the box can know; a person hears it, or does not.
CheckedState LineCheck::StateOfSound(Memory& memory, const View& view) const {
  const board::Stamped<board::Voice>& voice = view.board.voice;
  if (voice.source == SourceState::kLive && voice.value.speaking != 0) memory.heard = true;
  if (view.sound.value.xruns - memory.xruns > kMostXruns) return CheckedState::kNoisy;
  return memory.heard ? CheckedState::kSeen : CheckedState::kUnseen;
}

void LineCheck::ConfirmLamps(Time now) {
  for (std::uint32_t i = 0; i < result_.count; ++i)
    if (result_.items[i].kind == CheckedKind::kLamps) memories_[i].heard = true, changed_at_ = now;
}

std::uint32_t LineCheck::lamps(Time now) const {
  std::uint32_t all = 0, unseen = 0;
  for (const CheckedItem& item : board::ItemsOf(result_)) {
    if (item.kind != CheckedKind::kButton || IsOfStick(item)) continue;
    all |= 1U << item.number;
    if (item.state != CheckedState::kSeen) unseen |= 1U << item.number;
  }
  if (all == 0) return 0;
  const auto step = (now - began_at_) / kLampTime;
  const auto count = static_cast<Duration::rep>(std::popcount(all));
  if (step >= count && unseen != 0) return unseen;
  std::uint32_t left = all;
  // Without the lowest lamps, one for each that had its turn.
  for (auto n = step % count; n > 0; --n) left &= left - 1;
  return left & (~left + 1);
}

}  // namespace kaori::linecheck
