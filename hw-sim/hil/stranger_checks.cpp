// What is plugged in without a role stays dead; which roles there are is the profile's business.
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kStrangerAnswer = seconds(120);
constexpr Duration kStrangerLongest = seconds(120);
constexpr std::uint32_t kPlayedOn = 2;  // Frames.

const Setup kKiosk{.keyboards = false, .settings = "profile = \"kiosk\"\n"};
const Setup kFaulty{.settings = "# tonight\nprofile = \"open house\"\n",
                    .last_settings = "profile = \"bench\"\n"};
constexpr std::string_view kFault = "box.toml, line 2: there is no profile \"open house\"";

struct Kind {
  Stranger stranger;
  const char* name;
  const char* number;  // QEMU's vendor and product.
};

constexpr Kind kStorage{Stranger::kStorage, "a storage stick", "46f4:0001"};
constexpr Kind kNetwork{Stranger::kNetwork, "a network adapter", "0525:a4a2"};
constexpr Kind kKeyboard{Stranger::kKeyboard, "a keyboard", "0627:0001"};

// Whether the device of that number was let in; nothing: it is not there.
std::optional<bool> LetIn(Scene& scene, const char* number) {
  const auto devices = scene.place.witness().Ask("usb", kStrangerAnswer);
  std::istringstream lines(devices ? *devices : "");
  std::string port, numbers;
  for (int authorized = 0; lines >> port >> numbers >> authorized;)
    if (numbers == number) return authorized == 1;
  return std::nullopt;
}

Result<void> AwaitFrames(Scene& scene) {
  const auto before = scene.place.Board();
  if (!before) return tl::unexpected(before.error());
  const auto on = [&](const BoardView& board) {
    return board.stage.live && board.left.live && board.stage.frames >= before->stage.frames + kPlayedOn;
  };
  if (auto ok = scene.place.UntilBoard(on, kStrangerLongest, "see the box play on"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// Plugs it in, waits until udev has thought about it, and pulls it.
Result<void> WantLetIn(Scene& scene, const Kind& kind, bool wanted) {
  if (auto ok = scene.place.machine().PlugStranger(kind.stranger); !ok) return ok;
  const auto there = [&] { return LetIn(scene, kind.number).has_value(); };
  if (!scene.place.Until(there, kStrangerLongest))
    return Fail(std::errc::timed_out, fmt::format("see {} in the machine", kind.name));
  if (auto ok = scene.place.witness().Ask("own /usr/bin/udevadm settle --timeout=90", kStrangerAnswer); !ok)
    return tl::unexpected(ok.error());
  auto played = AwaitFrames(scene);
  const auto let_in = LetIn(scene, kind.number);
  if (auto ok = scene.place.machine().PullStranger(); !ok) return ok;
  if (!scene.place.Until([&] { return !LetIn(scene, kind.number); }, kStrangerLongest))
    return Fail(std::errc::timed_out, fmt::format("see {} gone", kind.name));
  if (!played) return played;
  if (let_in == wanted) return {};
  return FailInput(fmt::format("{} {}", kind.name, wanted ? "was not let in" : "was let in"));
}

Result<void> OnStage(Scene& scene) {
  for (const auto& [kind, wanted] : {std::pair{kStorage, false}, {kNetwork, false}, {kKeyboard, true}})
    if (auto ok = WantLetIn(scene, kind, wanted); !ok) return ok;
  scene.finding.said =
      "a storage stick and a network adapter stayed dead, a keyboard was let in; it played on";
  return {};
}

Result<void> InAKiosk(Scene& scene) {
  for (const auto& [kind, wanted] : {std::pair{kKeyboard, false}, {kStorage, false}})
    if (auto ok = WantLetIn(scene, kind, wanted); !ok) return ok;
  const auto board = scene.place.Board();
  if (!board) return tl::unexpected(board.error());
  if (board->keys_live) return FailInput("the keyboard that was plugged in before power came is alive");
  scene.finding.said = "keyboards stayed dead, plugged in before power came and after; dials and sticks live";
  return {};
}

// The file names a profile that does not exist; the one before it, which let everything in, counts.
Result<void> WithAFault(Scene& scene) {
  const auto log = scene.place.witness().Ask("own /usr/bin/journalctl -k -b --no-pager -o cat", kStrangerAnswer);
  if (!log) return tl::unexpected(log.error());
  const std::size_t at = log->find(kFault);
  if (at == std::string::npos) return FailInput("the fault is not named in the box's log");
  scene.finding.texts.emplace_back("the box's log", log->substr(at, log->find('\n', at) - at));
  for (const Kind& kind : {kStorage, kNetwork, kKeyboard})
    if (auto ok = WantLetIn(scene, kind, true); !ok) return ok;
  scene.finding.said = fmt::format("the log says: {}; the profile before, bench, let everything in",
                                   scene.finding.texts[0].second);
  return {};
}

}  // namespace

std::vector<Check> StrangerChecks() {
  return {
      {"strangers", "Storage and networks stay dead, and the box plays on", false, OnStage},
      {"kiosk", "In a kiosk keyboards stay dead", false, InAKiosk, kKiosk},
      {"faulty-settings", "A settings file with a mistake: the last good one counts, the mistake is named",
       false, WithAFault, kFaulty}};
}

}  // namespace kaori::hil
