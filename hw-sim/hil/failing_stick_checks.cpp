// Sticks that are pulled, cannot be read, or are slow while they bring an update: it is said, and what plays goes on.
#include <filesystem>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/number.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/stick_scene.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr int kPulls = 3, kUnreadable = 2;              // In each round.
constexpr std::string_view kTheUpdate = "> 1. ";        // The first line of its stick's list.
constexpr std::string_view kBegins = ": it is being ";  // Read, and then written.
constexpr std::string_view kFails = "cannot be read; take it again";
constexpr std::string_view kWaits = "it is on the box and waits";
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
  if (auto ok = scene.target.AwaitFrame(minutes(2), "see the face behind a stick that failed"); !ok)
    return ok;
  scene.finding.counts["sticks_failed"] += 1;
  return {};
}

Result<void> PullGone(Scene& scene) {
  static_cast<void>(scene.target.machine().PullUnauthorised());
  return WantListGone(scene);
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
  auto ok = InService(scene, "failing.disk", [&] {
    const auto tried = TryAll(scene);
    return tried ? scene.ShootFace("failing-sticks",
                                   "The face after sticks that failed, and an update that came in")
                 : tried;
  });
  scene.finding.said = fmt::format(
      "{:.0f} sticks that were pulled midway, could not be read or were slow were named, and nothing of them "
      "waits; the same update came in after them",
      scene.finding.counts["sticks_failed"]);
  return ok;
}

// The control: of a stick that is whole nothing of the kind is said.
Result<void> AWholeStickDoesNotFail(Scene& scene) {
  return InService(scene, nullptr, [&]() -> Result<void> {
    if (auto ok = BeginUpdate(scene, {}); !ok) return ok;
    const auto goes_on = [](const std::string& said) { return DoneOf(said).value_or(0) >= 2; };
    if (auto ok = UntilSaid(scene, goes_on); !ok) return ok;
    return WantFoundWrong(WantStickSaid(scene, kFails, seconds(5)), "a whole stick is said to fail");
  });
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
       .most_rounds = 4,
       .stick = "update"}};
}

}  // namespace kaori::hil
