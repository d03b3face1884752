// A factory reset at the box: GO is held with the service key on, in the first minute of a start, and let go.
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr Duration kResetAnswer = seconds(60);
// From power to the notice on an emulated machine: its start, and ten seconds in which GO is held.
constexpr Duration kUntilNotice = minutes(6);
constexpr Duration kUntilRestart = minutes(3);
constexpr int kGoWire = 0, kKeyWire = 2;  // Of the bridge, as docs/image.md wires them.
constexpr const char* kNotice = "read /run/kaori-reset/notice";
constexpr const char* kKeptName = "name = \"tour\"\n";  // What the box is to forget.

Setup OnResetDisk(const std::string& disk) {
  return {.sound = false, .keeps_disk = true, .width_px = 480, .height_px = 270, .disk = disk};
}

// Both are held before power comes, as by somebody who knows what they want.
class HeldLines {
 public:
  explicit HeldLines(Scene& scene) : bridge_(scene.target.rig().gpio()) {
    bridge_.Close(kKeyWire);
    bridge_.Close(kGoWire);
  }
  ~HeldLines() { LetGo(), bridge_.Open(kKeyWire); }
  HeldLines(const HeldLines&) = delete;
  HeldLines& operator=(const HeldLines&) = delete;
  void LetGo() { bridge_.Open(kGoWire); }

 private:
  sim::GpioBridge& bridge_;
};

bool NoticeSays(Scene& scene, std::string_view words) {
  return scene.target.agent().Ask(kNotice, kResetAnswer).value_or("").find(words) != std::string::npos;
}

// A box that is named starts with both lines held, and its status asks to let go. Gives the disk. Errors:
// invalid_argument, it does not.
Result<std::string> StartHeld(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  auto disk = CopyWithSettings(options.image + "/kaori.disk", {.settings = kKeptName}, options.folder);
  if (!disk) return disk;
  if (auto ok = scene.target.PlugAll(); !ok) return tl::unexpected(ok.error());
  if (auto ok = scene.SwitchOn(OnResetDisk(*disk)); !ok) return tl::unexpected(ok.error());
  if (auto ok = scene.target.agent().Find(kUntilNotice); !ok) return tl::unexpected(ok.error());
  if (scene.target.Until([&] { return NoticeSays(scene, "Let go of GO now"); }, kUntilNotice)) return disk;
  return FailInput("the status picture does not ask to let go of GO");
}

// Starts it again, with nothing held.
Result<void> WantForgotten(Scene& scene, const std::string& disk, bool forgotten) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(OnResetDisk(disk));
  const auto settings = scene.target.agent().Ask("read /var/lib/kaori/settings/box.toml", kResetAnswer);
  const bool has_name = settings.value_or("").find("tour") != std::string::npos;
  if (ok && has_name == forgotten)
    ok = FailInput(has_name ? "the box has kept its name" : "the box has lost its name");
  if (ok) ok = scene.ShootFace("factory-reset", forgotten ? "After the reset" : "Nothing was reset");
  if (ok) box.Off();
  return ok;
}

// `lets_go`: GO is let go when the status asks for it; else it stays held, as under a case.
Result<void> TryReset(Scene& scene, bool lets_go) {
  Result<void> ok;
  std::string disk;
  {
    HeldLines lines(scene);
    const auto started = StartHeld(scene);
    if (!started) return tl::unexpected(started.error());
    disk = *started;
    if (lets_go) lines.LetGo();
    const auto is_over = [&] {
      return !scene.target.machine().runs() || (!lets_go && !NoticeSays(scene, "GO"));
    };
    if (!scene.target.Until(is_over, kUntilRestart)) ok = FailInput("the box does not start again");
    if (ok && !lets_go && !scene.target.machine().runs())
      ok = FailInput("GO was never let go, and the box starts again");
  }
  scene.target.machine().Off();
  if (ok) ok = WantForgotten(scene, disk, lets_go);
  std::filesystem::remove(disk);
  return ok;
}

Result<void> FactoryReset(Scene& scene) {
  scene.finding.said = "GO held with the key on and let go: the box starts again, and has forgotten its name";
  return TryReset(scene, true);
}

// The control: under a case that stands on the foot switch nothing is forgotten.
Result<void> NothingIsForgottenUnderACase(Scene& scene) {
  return TryReset(scene, false);
}

}  // namespace

std::vector<Check> ResetChecks() {
  return {{.name = "factory-reset",
           .sentence = "GO held with the service key on has the box forget what it keeps",
           .run = FactoryReset,
           .setup = OnResetDisk(""),
           .control = NothingIsForgottenUnderACase,
           .powers = true}};
}

}  // namespace kaori::hil
