#include "hw-sim/hil/check_runner.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>
#include <variant>

#include "drivers/base/checksum.h"
#include "hw-sim/hil/kernel_fault.h"
#include "hw-sim/hil/paused_unit.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

// Of a box that has just failed: it may not answer at all.
constexpr Duration kLongestTrace = std::chrono::seconds(60);

// What helps to find out why.
// The first word of each pair is the heading in the report, the second the question to the agent.
constexpr const char* kFaultsQuestion = "faults";
constexpr const char* kTrivialQuestion =
    "hello";  // Whatever state the box is in, an agent that lives answers it.
constexpr std::pair<const char*, const char*> kTraces[] = {
    {"the board", "board"},
    {"the kernel's faults", kFaultsQuestion},
    {"the box's log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 300"},
    {"its devices", "usb"}};

constexpr const char* kInputUnit = "kaori-input.service";

// In a control nothing is expected to come, so waiting long would only cost time.
constexpr Duration kControlPatience = std::chrono::seconds(10);

// A fade on a machine whose processor draws, and the frames after it.
constexpr Duration kLongestLeaving = std::chrono::seconds(120);

// An agent may still be busy with a question that nobody waits for any more.
constexpr Duration kLongestFaults = std::chrono::minutes(5);

// Enough for the box to notice that a device is gone.
constexpr Duration kNoticesLoss = std::chrono::seconds(2);

// Whether checks that come later find its box as it leaves it: those of the usual setup come one after another.
bool IsShared(const Check& check) {
  return !check.powers && check.setup == Setup{};
}

// Whether its box can be asked before and after it.
bool HasAgent(const Check& check) {
  return !check.powers && check.setup.agent;
}

// Either is undone by its destructor.
using Withdrawn = std::variant<std::monostate, PausedUnit, UnpluggedDevice>;

// Stops a unit or unplugs a device until the result goes.
Withdrawn Withdraw(Scene& scene, const std::string& what) {
  if (what.ends_with(".service")) return Withdrawn(std::in_place_type<PausedUnit>, scene, what);
  return Withdrawn(std::in_place_type<UnpluggedDevice>, scene, what, kNoticesLoss);
}

}  // namespace

// A failure that is the bench's own lack is a skip with its reason. After any other failure the box is
// switched off, and the next check has a fresh one.
ReportedCheck CheckRunner::Run(const Check& check, int round) {
  ReportedCheck reported{check.name, check.sentence, {.rounds = 1}};
  Finding& finding = reported.finding;
  const auto name = static_cast<std::uint32_t>(Fnv1a(check.name, kFnvBasis));
  std::seed_seq seed{static_cast<std::uint32_t>(options_.seed), name, static_cast<std::uint32_t>(round)};
  chance_.seed(seed);
  auto ok = Prepare(check);
  const Time began = target_.clock().now();
  Scene scene = SceneOf(finding);
  scene.round = round;
  // The bench lacks what the check or its setup wants: a stick, Xvfb, a kernel of its own.
  if (!ok && ok.error().cause == std::errc::not_supported) {
    finding.verdict = Verdict::kSkipped;
    finding.said = ok.error().message();
    return reported;
  }
  if (ok) ok = RunWatched(check, scene);
  if (ok && options_.controls && round == 0 && finding.verdict == Verdict::kPassed)
    ok = Control(check, finding);
  if (ok && finding.verdict == Verdict::kPassed && IsShared(check)) ok = LeavesAFace();
  // Before the box may be switched off: what is not read now is said of no check.
  if (ok && HasAgent(check)) ok = WantNoKernelFault();
  finding.took_s = Seconds(target_.clock().now() - began);
  if (ok) return reported;
  finding.verdict = Verdict::kFailed;
  finding.said = ok.error().message();
  AddTraces(check.name, finding);
  // Whatever it left behind is not the next check's.
  strategy_.Off();
  return reported;
}

// The scene borrows all of it; `finding` must outlive it.
Scene CheckRunner::SceneOf(Finding& finding) {
  return {.target = target_,
          .finding = finding,
          .folder = options_.report,
          .replugs = options_.replugs,
          .scenes = options_.scenes,
          .chance = chance_,
          .play = options_.play};
}

// A check that powers the machine itself finds it off; all others find a box that plays.
Result<void> CheckRunner::Prepare(const Check& check) {
  const std::string stick = target_.machine().options().sticks + "/" + check.stick + ".stick";
  if (!check.stick.empty() && !std::filesystem::exists(stick))
    return Fail(std::errc::not_supported, "plug in " + stick + " (--sticks names the folder)");
  if (!check.powers) return StartBox(check.setup);
  strategy_.Off();
  return {};
}

// Programs that end by themselves are started again within a second: afterwards only the numbers of their processes tell.
Result<void> CheckRunner::RunWatched(const Check& check, Scene& scene) {
  if (auto ok = NotePrograms(check, scene); !ok) return ok;
  auto ok = check.run(scene);
  if (!ok || !IsShared(check) || check.ends_programs) return ok;
  const auto now = LookAtPrograms(target_.agent());
  if (!now) return tl::unexpected(now.error());
  const std::string ended = EndedSince(scene.programs, *now);
  return ended.empty() ? Result<void>{} : FailInput(ended);
}

Result<void> CheckRunner::NotePrograms(const Check& check, Scene& scene) {
  if (!HasAgent(check)) return {};
  auto programs = LookAtPrograms(target_.agent());
  if (!programs) return tl::unexpected(programs.error());
  scene.programs = std::move(*programs);
  return {};
}

// Else the next check that looks at the screen would fail, for a dial that this one left turned. The kernel keeps the last picture
// of a stage that has died or hangs, so one must have looked at the board since the check ended.
Result<void> CheckRunner::LeavesAFace() {
  if (auto ok = target_.AwaitFrame(kLongestLeaving, "see a frame afterwards"); !ok)
    return ok.error().cause == std::errc::timed_out
               ? FailInput("it passed, but leaves the next check a stage that draws no more")
               : ok;
  const std::string shot = options_.report + "/left.png";
  const auto face = [&] {
    const auto picture = target_.machine().Shoot(0, shot).and_then([&] { return LookAt(shot); });
    return picture && ShowsAFace(*picture);
  };
  const auto seen = target_.Await(face, kLongestLeaving, "see a face afterwards");
  return seen ? seen : FailInput("it passed, but leaves the next check a screen without a face");
}

// Each fault is told once: those before this check were told of the check before.
Result<void> CheckRunner::WantNoKernelFault() {
  // A machine that its watchdog has reset is gone with its log.
  if (!target_.machine().runs()) return {};
  const auto faults = target_.agent().Ask(kFaultsQuestion, kLongestFaults);
  if (!faults) return tl::unexpected(faults.error());
  std::istringstream lines(*faults);
  for (std::string line; std::getline(lines, line);)
    if (line != kPlantedFault) return FailInput("the kernel says: " + line);
  return {};
}

// A check that passes although what it looks for was taken away finds nothing: it fails then.
Result<void> CheckRunner::Control(const Check& check, Finding& finding) {
  // What the control finds is not the check's: it goes into a finding that nobody sees.
  Finding unseen;
  Scene scene = SceneOf(unseen);
  scene.folder += "/control";  // Its pictures are not those of the check.
  std::filesystem::create_directories(scene.folder);
  auto ok = check.control ? check.control(scene) : FailsWithout(check, scene);
  // Whoever could not try it has not seen that anything is found wrong.
  if (ok && unseen.verdict == Verdict::kSkipped)
    ok = FailInput("it could not be tried, since " + unseen.said);
  if (!ok) return FailInput("the negative control: " + ok.error().message());
  finding.control =
      check.control ? "; the control was found wrong" : "; it fails without " + check.fails_without;
  return {};
}

// What was withdrawn is there again afterwards; where the box does not recover the next check starts a new
// one. A check that skips is not said to fail: Control sees that.
Result<void> CheckRunner::FailsWithout(const Check& check, Scene& scene) {
  if (auto ok = NotePrograms(check, scene); !ok) return ok;
  const auto before = target_.Board();
  // The braces bring back what was withdrawn before the box is asked to recover.
  const bool passed = [&] {
    const auto away = Withdraw(scene, check.fails_without);
    target_.SetPatience(kControlPatience);
    const auto ok = check.run(scene);
    target_.ResetPatience();
    return ok && scene.finding.verdict == Verdict::kPassed;
  }();
  // Every check fails on a machine that is gone, which shows nothing of this one.
  const auto answer = target_.agent().Ask(kTrivialQuestion, kLongestFaults);
  // A box that does not recover is switched off, with its log.
  auto sound = WantNoKernelFault();
  strategy_.Recover(before && check.fails_without == kInputUnit ? before->now_ns : 0);
  if (passed) return FailInput("the check passes without " + check.fails_without);
  if (!answer)
    return FailInput("it could not be tried: the box answers no more (" + answer.error().message() + ")");
  return sound;
}

// A setup that did not start once is not tried again: each try costs minutes.
Result<void> CheckRunner::StartBox(const Setup& setup) {
  const auto before = std::ranges::find(failed_setups_, setup, &std::pair<Setup, Error>::first);
  if (before != failed_setups_.end())
    return FailAs(before->second, "not tried: the box did not start before; " + before->second.attempt);
  auto ok = strategy_.Play(setup);
  if (!ok) failed_setups_.emplace_back(setup, ok.error());
  // The first start is the one that is reported, whatever setup it had.
  if (boot_s_ == 0) boot_s_ = strategy_.boot_s();
  return ok;
}

// Into the report, so that a failure in the night can be read in the morning.
void CheckRunner::AddTraces(const std::string& check, Finding& finding) {
  const std::string file = check + "-failed.png";
  if (target_.machine().Shoot(0, options_.report + "/" + file))
    finding.pictures.push_back({file, "When it failed"});
  finding.texts.emplace_back("QEMU's log", target_.machine().log());
  // A box that does not answer gives no text; the report then has QEMU's log alone.
  for (const auto& [name, question] : kTraces)
    if (const auto told = target_.agent().Ask(question, kLongestTrace); told && !told->empty())
      finding.texts.emplace_back(name, *told);
}

}  // namespace kaori::hil
