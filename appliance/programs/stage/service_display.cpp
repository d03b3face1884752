#include "appliance/programs/stage/service_display.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace kaori::stage {
namespace {

using std::chrono::milliseconds;

// Twenty of the writer's periods of 25 ms, and three of the desk's of a second: what has been silent for
// longer has ended, and its lines must not stay on the screen.
constexpr Duration kGuideSilence = milliseconds(500);
constexpr Duration kDeskSilence = milliseconds(3000);
constexpr Duration kBlink = milliseconds(800);
constexpr Duration kFastBlink = milliseconds(200);
constexpr std::uint32_t kPoses = 4;
constexpr std::uint8_t kEnter = 0x28, kEscape = 0x29, kPadEnter = 0x58;  // HID page 7.

// A blink from the clock alone, so that all lamps blink in step and nothing is remembered.
bool IsOn(Time now, Duration period) {
  return now.time_since_epoch() % period < period / 2;
}

// Two or three short lines: they stand beside the face. The second one warns where no mouth is seen.
std::vector<std::string> GuideLines(const board::LipsGuide& guide) {
  constexpr std::array<const char*, kPoses> kNames{"shut", "open", "wide", "narrow"};
  if (guide.step >= kPoses) return {"lips: all is taken", "Enter keeps it   Esc goes back"};
  const char* name = kNames[guide.step];
  const std::string seen = guide.seen != 0 ? "" : "no mouth is seen";
  if (guide.taking != 0)
    return {fmt::format("lips {} of 4: {}", guide.step + 1, name),
            seen.empty() ? fmt::format("hold it ... {:.0f} %", 100 * guide.progress) : seen};
  std::vector<std::string> lines{fmt::format("lips {} of 4: mouth {}", guide.step + 1, name),
                                 "Enter takes it   Esc goes back"};
  if (!seen.empty()) lines.insert(lines.begin() + 1, seen);
  return lines;
}

// The address to type, the code, and the first bytes of the certificate's fingerprint, which a visitor
// compares with what the browser shows.
std::vector<std::string> DeskLines(const board::Desk& desk) {
  const std::uint32_t a = desk.address, c = desk.certificate;
  std::vector<std::string> lines{fmt::format("{}://{}.{}.{}.{}:{}", desk.secure != 0 ? "https" : "http",
                                             a >> 24, a >> 16 & 255U, a >> 8 & 255U, a & 255U, desk.port),
                                 fmt::format("code {:03} {:03}", desk.code / 1000, desk.code % 1000)};
  if (c != 0)
    lines.push_back(fmt::format("certificate {:02X} {:02X} {:02X} {:02X}", c >> 24, c >> 16 & 255U,
                                c >> 8 & 255U, c & 255U));
  return lines;
}

// How far the line check is, and what is next: the first item that was not seen, or does not work.
std::vector<std::string> CheckLines(const board::LineCheck& check) {
  std::vector<std::string> lines{fmt::format("line check: {} of {} seen", board::SeenOf(check), check.count)};
  const auto items = board::ItemsOf(check);
  const auto next = std::ranges::find_if(
      items, [](const board::CheckedItem& item) { return item.state != board::CheckedState::kSeen; });
  if (next != items.end())
    lines.push_back(fmt::format("{}: {}", board::DeviceOf(*next), board::PhraseOf(*next)));
  lines.push_back("no control moves the face; Home ends it");
  return lines;
}

// A code that has run out is not shown even where the desk hangs and cannot take it away.
bool HasCode(const board::Stamped<board::Desk>& desk, Time now) {
  const Duration age = now - desk.at;
  return desk.source == board::SourceState::kLive && age < kDeskSilence &&
         age < FromSeconds(desk.value.valid_s);
}

}  // namespace

// In front of what the editor may have put there; a caption that is not shown holds lines of an earlier
// frame.
void Say(const std::vector<std::string>& lines, scene::Caption& caption) {
  if (!(caption.shown > 0)) caption.lines.clear();
  caption.shown = 1;
  caption.lines.insert(caption.lines.begin(), lines.begin(), lines.end());
}

bool IsGuiding(const board::Stamped<board::LipsGuide>& guide, Time now) {
  return guide.source == board::SourceState::kLive && now - guide.at < kGuideSilence;
}

bool IsChecking(const board::Stamped<board::LineCheck>& check, Time now) {
  return check.source == board::SourceState::kLive && check.value.phase == board::LineCheckPhase::kRunning &&
         now - check.at < kGuideSilence;
}

// Every button confirms a pose, and the three keys confirm or cancel (lips/service/guide.cpp). Other keys
// stay the show's.
void ConsumeGuideInput(performance::InputEvents& events) {
  events.Consume([](const performance::Press& press) {
    return !press.IsKey() || press.code == kEnter || press.code == kEscape || press.code == kPadEnter;
  });
}

// One lamp a pose: lit where it is done, blinking where it is asked for and faster while it is measured. All
// four blink when the calibration waits to be saved.
std::uint32_t GuideLamps(const board::LipsGuide& guide, Time now) {
  if (guide.step >= kPoses) return IsOn(now, kBlink) ? (1U << kPoses) - 1 : 0;
  const bool on = IsOn(now, guide.taking != 0 ? kFastBlink : kBlink);
  return ((1U << guide.step) - 1) | (on ? 1U << guide.step : 0);
}

// One at a time: the calibration is what somebody stands before the box for.
void ShowService(const board::Snapshot& board, Time now, scene::Scene& scene) {
  if (IsGuiding(board.lips_guide, now) && board.lips_guide.value.captions != 0)
    return Say(GuideLines(board.lips_guide.value), scene.caption);
  if (IsChecking(board.line_check, now)) return Say(CheckLines(board.line_check.value), scene.caption);
  if (HasCode(board.desk, now)) Say(DeskLines(board.desk.value), scene.caption);
}

}  // namespace kaori::stage
