#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {

// `part` is 0 to 1; the nearest value below is given, without interpolation.
double Quantile(std::vector<double> values, double part) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

std::map<std::string, double> Finding::Measured() const {
  auto measured = figures;
  measured.insert(counts.begin(), counts.end());
  return measured;
}

// Where a round has not passed, its number counts those before it.
std::string Finding::Said() const {
  if (rounds <= 1) return said + control;
  if (verdict != Verdict::kPassed) return fmt::format("in round {}: {}", rounds, said);
  return fmt::format("{} rounds, and of the last one: {}{}", rounds, said, control);
}

void Scene::TapKey(std::uint8_t usage) {
  sim::Keyboard& keyboard = target.rig().devices().keyboard;
  keyboard.Press(usage);
  target.For(std::chrono::milliseconds(500));
  keyboard.Release(usage);
}

Result<void> Scene::Shoot(const std::string& name, const std::string& caption) {
  // The number keeps several pictures of one check apart.
  const std::string of_round = round > 0 ? fmt::format("-{}", round) : "";
  const std::string file = fmt::format("{}{}-{}.png", name, of_round, finding.pictures.size());
  if (auto ok = target.machine().Shoot(0, folder + "/" + file); !ok) return ok;
  finding.pictures.push_back({file, caption});
  return {};
}

// The picture stays in the report in either case: what is there in place of a face is worth seeing.
Result<void> Scene::ShootFace(const std::string& name, const std::string& caption) {
  if (auto ok = Shoot(name, caption); !ok) return ok;
  const auto picture = LookAt(folder + "/" + finding.pictures.back().file);
  if (!picture) return tl::unexpected(picture.error());
  if (!ShowsAFace(*picture)) return FailInput("no face is on the screen: " + Describe(*picture));
  return {};
}

// Two minutes: the agent is beside a face that takes all that the processors give.
Result<void> Scene::Tell(const std::string& question) {
  const auto told = target.agent().Ask(question, std::chrono::seconds(120));
  if (!told) return tl::unexpected(told.error());
  return {};
}

// First a face, then a later picture that differs from it: a picture that stands could be the last one of a
// stage that died.
Result<void> Scene::AwaitMovingFace(int head, Duration longest) {
  // Both files are replaced at each look; the report does not show them.
  const std::string first = folder + "/moving-first.png", later = folder + "/moving-later.png";
  const auto face = [&] {
    if (!target.machine().Shoot(head, first)) return false;
    const auto picture = LookAt(first);
    return picture && ShowsAFace(*picture);
  };
  const auto moved = [&] {
    if (!target.machine().Shoot(head, later)) return false;
    const auto changed = ChangedPart(first, later);
    return changed && *changed > 0;
  };
  if (auto ok = target.Await(face, longest, fmt::format("see a face on screen {}", head + 1)); !ok) return ok;
  return target.Await(moved, longest, fmt::format("see the face move on screen {}", head + 1));
}

// A box on which somebody plays all the time is given up on after half a minute, and taken as it is.
Result<BoardView> Scene::SettledBoard() {
  constexpr int kMostLooks = 30;
  auto before = target.Board();
  for (int looks = 0; before && looks < kMostLooks; ++looks) {
    target.For(std::chrono::seconds(1));
    auto now = target.Board();
    // Dials and buttons alone are compared, over a second of time.
    if (now && now->counts == before->counts && now->pushes == before->pushes) return now;
    before = std::move(now);
  }
  return before;
}

// The other programs are the runner's business: a check that ends some of them may still want this of the stage.
Result<void> Scene::WantNoRestart() {
  const auto now = LookAtPrograms(target.agent());
  if (!now) return tl::unexpected(now.error());
  auto stage = programs;
  std::erase_if(stage, [](const BoxProgram& program) { return program.name != "kaori-stage"; });
  if (stage.empty()) return Fail(std::errc::no_such_process, "compare the stage with that of the beginning");
  const std::string ended = EndedSince(stage, *now);
  return ended.empty() ? Result<void>{} : FailInput(ended);
}

Result<void> Scene::SwitchOn(const Setup& setup) {
  target.machine().SetUp(setup);
  return target.machine().On();
}

Result<void> Scene::Skip(std::string why) {
  finding.verdict = Verdict::kSkipped;
  finding.said = std::move(why);
  return {};
}

Result<void> WantFoundWrong(const Result<void>& tried, const char* passed) {
  if (tried) return FailInput(passed);
  return tried.error().kind == ErrorKind::kInput ? Result<void>{} : tried;
}

// Those that want the same setup stand together: another one is a box started anew.
std::vector<Check> AllChecks() {
  std::vector<Check> all;
  for (auto& part : {ScreenChecks(),   PlayChecks(),          InputChecks(),       SurfaceChecks(),
                     ChipChecks(),     SerialBoxChecks(),     MachineLineChecks(), LatencyChecks(),
                     CameraChecks(),   LineChecks(),          SoundChecks(),       LibcameraChecks(),
                     CableChecks(),    HangChecks(),          CrashChecks(),       ToolChecks(),
                     ReportChecks(),   AuthorisationChecks(), AloneChecks(),       UsbSoundChecks(),
                     SpeedChecks(),    GadgetChecks(),        LoopChecks(),        DamagedDiskChecks(),
                     DialLineChecks(), SamplingChecks(),      DisplayChecks(),     OutputChecks(),
                     LastFaceChecks(), StormChecks(),         RecoveryChecks(),    PowerChecks(),
                     StickChecks(),    FailingStickChecks(),  GivesWayChecks(),    BackupChecks(),
                     DeskChecks(),     DataChecks(),          ResetChecks(),       StartChecks(),
                     DiskChecks(),     SecureBootChecks(),    UpdateChecks(),      BadUpdateChecks(),
                     TryCutChecks(),   PowerCycleChecks(),    SpoiltFileChecks(),  MediumChecks()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace kaori::hil
