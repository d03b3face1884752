// The desk of a box whose settings name an address: there while the service key is on, for nobody at any other time.
#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/stick_scene.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

// Of this computer; the kernel's own choice of ports begins above it.
constexpr int kDeskPort = 28443;
// Its address in slirp's network, as QemuCommand forwards the port.
constexpr const char* kWithAddress = "[network]\naddress = \"10.0.2.15/24\"\n";
// Sockets that listen (state 0A), by the port 8443 in hexadecimal digits (proc(5)).
constexpr const char* kSockets = "read /proc/net/tcp";
constexpr std::string_view kListens = ":20FB 00000000:0000 0A";
// Everything is emulated: the desk makes a key for its certificate first.
constexpr Duration kLongestDesk = std::chrono::minutes(5);

// A small screen without sound starts soonest; the settings replace those of the data partition.
Setup DeskSetup(const char* settings) {
  return {.sound = false, .width_px = 480, .height_px = 270, .desk_port = kDeskPort, .settings = settings};
}

// The socket is looked for in the guest: slirp accepts a connection here whether or not anybody
// listens there.
bool Listens(Scene& scene) {
  return TextInBox(scene, kSockets).find(kListens) != std::string::npos;
}

// What a browser gets that has not paired: the page's own first question. Empty where nobody answers.
std::string Hello(Scene& scene) {
  const std::string answer = scene.folder + "/hello.json";
  const auto asked = RunToEnd({"curl", "--silent", "--insecure", "--max-time", "20", "--output", answer,
                               fmt::format("https://127.0.0.1:{}/hello", kDeskPort)},
                              scene.folder + "/curl.log");
  return asked ? ReadFile(answer).value_or("") : "";
}

// The bench's simulated devices stand still while another program runs, so the socket is awaited first.
Result<void> WantDesk(Scene& scene) {
  if (!scene.target.Until([&] { return Listens(scene); }, kLongestDesk)) {
    scene.finding.texts.emplace_back(
        "what the box logged of the desk",
        TextInBox(scene, "own /usr/bin/journalctl -b -n 300 --no-pager -o short-monotonic"));
    return FailInput("the service key is on, and no desk listens");
  }
  if (const std::string said = Hello(scene); said.find("\"paired\"") == std::string::npos)
    return FailInput("the desk answers a visitor with \"" + said + "\"");
  return scene.ShootFace("desk", "The desk's address and its code, while the service key is on");
}

// The key is turned back in each case, since the next check finds the bridge as it was left.
Result<void> IsThereWithTheKey(Scene& scene) {
  if (Listens(scene)) return FailInput("a desk listens though the service key is off");
  scene.target.rig().gpio().Close(kStickKey);
  auto ok = WantDesk(scene);
  scene.target.rig().gpio().Open(kStickKey);
  if (ok && !scene.target.Until([&] { return !Listens(scene); }, kLongestDesk))
    ok = FailInput("the service key is off again, and the desk still listens");
  scene.finding.said =
      "a visitor of the box's network gets the desk while the service key is on, and nobody before and after";
  return ok;
}

// The control: the same box without an address has no desk, whatever the key says.
Result<void> IsNotThereWithoutAnAddress(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(DeskSetup("profile = \"stage\"\n"));
  scene.target.SetPatience(std::chrono::seconds(60));
  scene.target.rig().gpio().Close(kStickKey);
  if (ok) ok = WantFoundWrong(WantDesk(scene), "a box without an address has a desk");
  scene.target.rig().gpio().Open(kStickKey);
  scene.target.ResetPatience();
  box.Off();
  return ok;
}

Result<void> Desk(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(DeskSetup(kWithAddress));
  if (ok) ok = IsThereWithTheKey(scene);
  box.Off();
  return ok;
}

}  // namespace

std::vector<Check> DeskChecks() {
  return {
      {"desk",
       "A box with an address lets a visitor of its network calibrate the lips while the service key is on",
       false,
       Desk,
       DeskSetup(kWithAddress),
       {},
       IsNotThereWithoutAnAddress,
       true}};
}

}  // namespace kaori::hil
