// Sticks that are pulled, cannot be read, or are slow while they bring an update: it is said, and what plays goes on.
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/number.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr int kPulls = 3, kUnreadable = 2;              // In each round.
constexpr std::string_view kTheUpdate = "> 1. ";        // The first line of its stick's list.
constexpr std::string_view kBegins = ": it is being ";  // Read, and then written.
constexpr std::string_view kFails = "cannot be read; take it again";
constexpr std::string_view kWaits = "it is on the box and waits";
// Without another word or percent, as in stick_checks.cpp.
constexpr Duration kLongestStandstill = minutes(10);
// As a stick of the first USB, and so long it is watched.
constexpr std::int64_t kSlow_bytes_s = 100'000;
constexpr Duration kWatchesSlow = seconds(60);

// How far the box says that the update is, in percent; nothing where it says none.
std::optional<int> DoneOf(std::string_view said) {
  constexpr std::string_view kPercent = " %)";
  const std::size_t end = said.find(kPercent);
  if (end == said.npos) return std::nullopt;
  return ParseNumber<int>(said.substr(said.rfind('(', end) + 1, end - said.rfind('(', end) - 1));
}

// Looks at what the box says until `right` of it. Errors: invalid_argument, nothing new comes any more, with what was said last.
Result<void> UntilSaid(Scene& scene, const std::function<bool(const std::string&)>& right) {
  std::string said = TextInBox(scene, kSaid);
  while (!right(said)) {
    const auto is_new = [&, before = said] {
      // No answer is nothing new.
      if (std::string heard = TextInBox(scene, kSaid); !heard.empty()) said = std::move(heard);
      return said != before;
    };
    if (!scene.target.Until(is_new, kLongestStandstill))
      return FailInput("the update does not go on, and the box says \"" + said + "\"");
  }
  return {};
}

// The list of the stick before has to be gone, since its words are the same.
Result<void> BeginUpdate(Scene& scene, const StickFault& fault) {
  auto& machine = scene.target.machine();
  if (auto ok = machine.PlugFailingStick(machine.options().sticks + "/update.stick", fault); !ok) return ok;
  if (auto ok = WantStickSaid(scene, kTheUpdate, kLongestReading); !ok) return ok;
  return PressFor(scene, kOne, kBegins);
}

// Nothing of it waits, and the face moves. What is read back of the slot meanwhile takes its time.
Result<void> WantGivenUp(Scene& scene, const std::string& what) {
  const auto ended = [](const std::string& said) { return said.find(kBegins) == said.npos; };
  if (auto ok = UntilSaid(scene, ended); !ok) return ok;
  if (auto ok = WantStickSaid(scene, kFails, seconds(30)); !ok) return ok;
  scene.target.For(seconds(5));  // Until it is drawn as well.
  if (auto ok = scene.Shoot("failing-sticks", fmt::format("What is said of a stick that {}", what)); !ok)
    return ok;
  if (const std::string waits = TextInBox(scene, "read /var/lib/kaori/update/pending"); !waits.empty())
    return FailInput(fmt::format("an update of which only a part came waits: \"{}\"", waits));
  const auto now = scene.target.Board();
  if (!now) return tl::unexpected(now.error());
  const auto draws = [&](const BoardView& board) {
    return board.stage.live && board.stage.read_ns > now->now_ns;
  };
  const auto drawn = scene.target.UntilBoard(draws, minutes(2), "see the face behind a stick that failed");
  if (!drawn) return tl::unexpected(drawn.error());
  scene.finding.counts["sticks_failed"] += 1;
  return {};
}

Result<void> PullGone(Scene& scene) {
  static_cast<void>(scene.target.machine().PullUnauthorised());
  const auto gone = [&] { return TextInBox(scene, kSaid).find(kTheUpdate) == std::string::npos; };
  return scene.target.Until(gone, kLongestReading) ? Result<void>{}
                                                   : FailInput("the list of a pulled stick stays");
}

// Each pull in its own part of the way, where chance has it. What the box has in memory of the stick would do without it: it is
// forgotten first, as on a box with little memory.
Result<void> PullMidway(Scene& scene, int number) {
  // While it is read, while the root is written, and while that is read back, at the end of which the stick is asked for the rest.
  constexpr int kAll_percent = 60, kPart_percent = kAll_percent / kPulls;
  const int least = number * kPart_percent;
  const int until = std::uniform_int_distribution<int>(least, least + kPart_percent - 1)(scene.chance);
  if (auto ok = BeginUpdate(scene, {}); !ok) return ok;
  const auto far = [&](const std::string& said) { return DoneOf(said).value_or(0) >= until; };
  if (auto ok = UntilSaid(scene, far); !ok) return ok;
  if (auto ok = scene.Tell("write /proc/sys/vm/drop_caches 1"); !ok) return ok;
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return ok;
  const std::string what = fmt::format("was pulled at {} %", until);
  if (auto ok = WantGivenUp(scene, what); !ok) return FailAs(ok.error(), what + ": " + ok.error().attempt);
  return PullGone(scene);
}

// Somewhere within the update, which fills the first half of its stick.
Result<void> ReadUnreadable(Scene& scene) {
  const auto bytes = std::filesystem::file_size(scene.target.machine().options().sticks + "/box.kaoriupdate");
  const auto at = std::uniform_int_distribution<std::uintmax_t>(bytes / 4, bytes - 1)(scene.chance);
  auto ok = BeginUpdate(scene, {.unreadable_at = at, .most_bytes_s = 0});
  const std::string what = fmt::format("cannot be read at byte {}", at);
  if (ok) ok = WantGivenUp(scene, what);
  if (!ok) return FailAs(ok.error(), what + ": " + ok.error().attempt);
  return PullGone(scene);
}

// A slow one is waited for as long as it goes on at all.
Result<void> WaitForSlow(Scene& scene) {
  if (auto ok = BeginUpdate(scene, {.unreadable_at = std::nullopt, .most_bytes_s = kSlow_bytes_s}); !ok)
    return ok;
  scene.target.For(kWatchesSlow);
  if (TextInBox(scene, kSaid).find(kBegins) == std::string::npos)
    return FailInput("a slow stick is not waited for");
  const auto goes_on = [](const std::string& said) { return DoneOf(said).value_or(0) >= 1; };
  if (auto ok = UntilSaid(scene, goes_on); !ok) return ok;
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (auto ok = WantGivenUp(scene, "was slow, and was pulled"); !ok) return ok;
  return PullGone(scene);
}

// After all that the same update comes in whole, over whatever the others left in the slot.
Result<void> TryAll(Scene& scene) {
  for (int n = 0; n < kPulls; ++n)
    if (auto ok = PullMidway(scene, n); !ok) return ok;
  for (int n = 0; n < kUnreadable; ++n)
    if (auto ok = ReadUnreadable(scene); !ok) return ok;
  if (auto ok = WaitForSlow(scene); !ok) return ok;
  if (auto ok = BeginUpdate(scene, {}); !ok) return ok;
  return UntilSaid(scene, [](const std::string& said) { return said.find(kWaits) != said.npos; });
}

Result<void> FailingSticks(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  if (!std::filesystem::exists(options.sticks + "/update.stick"))
    return scene.Skip("there is no stick with an update; --sticks names its folder");
  const auto disk = CopyDisk(options.image + "/kaori.disk", options.folder, "failing.disk", "data");
  if (!disk) return tl::unexpected(disk.error());
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(disk->file));
  scene.target.rig().gpio().Close(kStickKey);
  if (ok) ok = TryAll(scene);
  if (ok)
    ok = scene.ShootFace("failing-sticks", "The face after sticks that failed, and an update that came in");
  scene.target.rig().gpio().Open(kStickKey);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  box.Off();
  std::filesystem::remove(disk->file);
  scene.finding.said = fmt::format(
      "{:.0f} sticks that were pulled midway, could not be read or were slow were named, and nothing of them "
      "waits; the same update came in after them",
      scene.finding.counts["sticks_failed"]);
  return ok;
}

// The control: of a stick that is whole nothing of the kind is said.
Result<void> AWholeStickDoesNotFail(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(""));
  scene.target.rig().gpio().Close(kStickKey);
  if (ok) ok = BeginUpdate(scene, {});
  const auto goes_on = [](const std::string& said) { return DoneOf(said).value_or(0) >= 2; };
  if (ok) ok = UntilSaid(scene, goes_on);
  if (ok) ok = WantFoundWrong(WantStickSaid(scene, kFails, seconds(5)), "a whole stick is said to fail");
  scene.target.rig().gpio().Open(kStickKey);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  box.Off();
  return ok;
}

}  // namespace

std::vector<Check> FailingStickChecks() {
  return {
      {.name = "failing-sticks",
       .sentence =
           "An update whose stick is pulled, cannot be read or is slow is given up or waited for, and said",
       .run = FailingSticks,
       .setup = StickSetup(""),
       .control = AWholeStickDoesNotFail,
       .powers = true,
       .most_rounds = 4}};
}

}  // namespace kaori::hil
