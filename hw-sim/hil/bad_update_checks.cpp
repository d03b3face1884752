// Bad versions of the box that really start: each is tried once, and the system before plays again.
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/bad_slot.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/update_scene.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// A trial gives a stage three minutes to show its face, after the start of an emulated machine; where nobody looks, kaori-trial.timer ends
// it eight minutes after that.
constexpr Duration kLongestGivingWay = kLongestUpdateStart + minutes(10);
// Until somebody switches a box off that shows nothing at all: some times as long as a start takes to its first program.
constexpr Duration kUntilSwitchedOff = minutes(4);
// A face is looked at for a minute before it is kept.
constexpr Duration kLongestKeeping = minutes(6);

// Text of the shader that lays the face over its backdrop, and what it becomes.
constexpr std::string_view kLight = "light + root * root", kNoLight = "root*0.0 * root    ";
constexpr std::string_view kUpright = "void main() {\n  ivec2 at = ivec2(gl_FragCoord.xy);\n#ifdef SAMPLES";
constexpr std::string_view kOnItsSide = "void main() {\n  ivec2 at = ivec2(gl_FragCoord.yx);\n#ifdef SAMPLES";
// A remark there, which changes nothing.
constexpr std::string_view kRemark = "// A layer over the backdrop.",
                           kOtherRemark = "// A layer over the BACKDROP.";
constexpr std::string_view kNotTheFace = "the picture is not that of the face";
static_assert(kLight.size() == kNoLight.size() && kUpright.size() == kOnItsSide.size());

struct BadVersion {
  // For people, as the beginning of a sentence.
  const char* name;
  // Null: its command line names a root that is not there, which makes the kernel panic.
  Result<void> (*spoil)(BadSlot& slot);
  // What the box says of it afterwards, of which this is a part; empty: nothing, since nothing of it came to look.
  std::string_view reason;
  // It does nothing for ever, and the hardware's watchdog is not armed yet: somebody switches it off.
  bool is_switched_off = false;
  // The box has no last face when it is tried: what the version keeps as one must not speak for itself.
  bool without_last_face = false;
};

// From what ends before anything of the box runs to what only an eye would see.
constexpr std::array kBadVersions{
    BadVersion{"a kernel that panics", nullptr, ""},
    BadVersion{"a first program that ends",
               [](BadSlot& slot) { return slot.Begin("kaori-boot", kEndsAtOnce); }, ""},
    BadVersion{"a first program that hangs",
               [](BadSlot& slot) { return slot.Begin("kaori-boot", kTurnsForEver); }, "", true},
    BadVersion{"a stage that crashes",
               [](BadSlot& slot) { return slot.Begin("kaori-stage", kInvalidInstruction); }, "kaori-stage"},
    BadVersion{"a stage that hangs", [](BadSlot& slot) { return slot.Begin("kaori-stage", kTurnsForEver); },
               "kaori-stage"},
    BadVersion{"a look that ends at once",
               [](BadSlot& slot) { return slot.Begin("kaori-update", kEndsAtOnce); }, ""},
    BadVersion{"a black picture", [](BadSlot& slot) { return slot.Replace("kaori-stage", kLight, kNoLight); },
               kNotTheFace},
    BadVersion{.name = "a black picture on a box without a last face",
               .spoil = [](BadSlot& slot) { return slot.Replace("kaori-stage", kLight, kNoLight); },
               .reason = kNotTheFace,
               .without_last_face = true},
    BadVersion{"another picture",
               [](BadSlot& slot) { return slot.Replace("kaori-stage", kUpright, kOnItsSide); }, kNotTheFace}};

// The end of slot B's command line with the last letter of its root's name changed. Errors: those of the files.
Result<void> NameNoRoot(const std::string& disk, const std::string& image) {
  constexpr std::string_view kRoot = "root=/dev/dm-0 ";
  const auto line = ReadFile(image + "/cmdline-b");
  if (!line) return tl::unexpected(line.error());
  const std::size_t at = line->rfind(kRoot);
  if (at == line->npos) return FailInput(image + "/cmdline-b names no root");
  const std::string end = line->substr(at, line->find('\n', at) - at);
  std::string other = end;
  other[kRoot.size() - 2] = '9';
  return ReplaceOnBoot(disk, end, other);
}

// Behind the back of the box that has read the slot back, as at the host two starts apart.
Result<void> Spoil(Scene& scene, const UpdatedPc& pc, const BadVersion& version) {
  const QemuOptions& options = scene.target.machine().options();
  if (version.spoil == nullptr) return NameNoRoot(pc.Disk(), options.image);
  auto slot = BadSlot::Open(pc.Disk(), options.image, options.folder);
  if (!slot) return tl::unexpected(slot.error());
  if (auto ok = version.spoil(*slot); !ok) return ok;
  return slot->Write();
}

// Until the try is over: the machine starts anew, or is switched off.
Result<void> EndTry(Scene& scene, const BadVersion& version) {
  const auto ended = [&] { return !scene.target.machine().runs(); };
  const bool has_ended =
      scene.target.Until(ended, version.is_switched_off ? kUntilSwitchedOff : kLongestGivingWay);
  scene.target.machine().Off();
  if (has_ended != version.is_switched_off) return {};
  return FailInput(fmt::format("{} {}", version.name,
                               has_ended ? "starts again although nothing runs" : "does not give way"));
}

// The system before plays, is the one that starts by itself, and knows that the other one was tried and why it gave way.
Result<void> WantBefore(Scene& scene, const UpdatedPc& pc, const BadVersion& version) {
  const std::string said = pc.Kept("update/last-try");
  auto ok = pc.Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the system before");
  if (ok) ok = scene.ShootFace("bad-updates", fmt::format("The system before, after {}", version.name));
  scene.target.machine().Off();
  scene.finding.texts.emplace_back(version.name, said);
  if (ok && pc.Default() != 'a') ok = FailInput(fmt::format("{} was confirmed", version.name));
  if (ok && !pc.Kept("update/pending").ends_with(" B 1\n"))
    ok = FailInput(
        fmt::format("after {} the try is not kept: \"{}\"", version.name, pc.Kept("update/pending")));
  if (ok && version.reason.empty() != said.empty())
    ok = FailInput(fmt::format("of {} it is said: \"{}\"", version.name, said.substr(0, said.find('\n'))));
  if (ok && said.find(version.reason) == said.npos)
    ok = FailInput(
        fmt::format("{} gave way for another reason: \"{}\"", version.name, said.substr(0, said.find('\n'))));
  return ok;
}

// One start of the version, and one of the system before.
Result<void> TryOnce(Scene& scene, const BadVersion& version) {
  const auto pc = RestartedPc(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = Spoil(scene, *pc, version);
  if (ok && version.without_last_face) ok = pc->Remove("own/last-face");
  if (ok) ok = pc->Start(scene);
  if (ok) ok = EndTry(scene, version);
  if (ok) ok = WantBefore(scene, *pc, version);
  scene.target.machine().Off();
  return ok;
}

// One in each round, from the same moment: a copy of the PC that has the update and was restarted to try it.
Result<void> ABadVersionGivesWay(Scene& scene) {
  const BadVersion& version = kBadVersions.at(static_cast<std::size_t>(scene.round));
  if (auto ok = TryOnce(scene, version); !ok) return ok;
  scene.finding.counts["bad_versions_booted"] = 1;
  scene.finding.said = fmt::format("{} was tried once and gave way", version.name);
  return {};
}

// The control: a version that was changed in the same way, and is good, stays: what gives way does so for what was spoilt.
Result<void> AGoodVersionStays(Scene& scene) {
  const auto pc = RestartedPc(scene);
  if (!pc) return tl::unexpected(pc.error());
  const BadVersion good{"a good version",
                        [](BadSlot& slot) { return slot.Replace("kaori-stage", kRemark, kOtherRemark); }, ""};
  auto ok = Spoil(scene, *pc, good);
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of a good version");
  const auto stays = [&](const std::string& kept) { return kept.empty() && pc->Default() == 'b'; };
  if (ok) ok = AwaitKept(scene, *pc, "update/pending", stays, kLongestKeeping);
  scene.target.machine().Off();
  return ok;
}

}  // namespace

std::vector<Check> BadUpdateChecks() {
  return {{.name = "bad-updates",
           .sentence = "A version that does not start, or shows no face, is tried once and gives way",
           .run = ABadVersionGivesWay,
           .setup = {.plugged = false, .sound = false, .agent = false},
           .control = AGoodVersionStays,
           .powers = true,
           .least_rounds = kBadVersions.size(),
           .most_rounds = kBadVersions.size(),
           .release = true,
           .stick = "update"}};
}

}  // namespace kaori::hil
