// The desk of a box whose settings name an address: there while the service key is on, for nobody at any other time.
#include <charconv>

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
// Of the page: a press is answered within a second on a machine that is none of these.
constexpr Duration kLongestPage = std::chrono::minutes(2);

// A small screen without sound starts soonest; the settings replace those of the data partition.
Setup DeskSetup(const char* settings) {
  return {.sound = false, .width_px = 480, .height_px = 270, .desk_port = kDeskPort, .settings = settings};
}

// The socket is looked for in the guest: slirp accepts a connection here whether or not anybody
// listens there.
bool Listens(Scene& scene) {
  return TextInBox(scene, kSockets).find(kListens) != std::string::npos;
}

// What a browser gets, by the page's own requests: GET, or POST where there is a body. Its cookie lies in the folder. Empty where
// nobody answers.
std::string AskDesk(Scene& scene, const std::string& path, const std::string& body = {}) {
  const std::string answer = scene.folder + "/desk.answer", cookies = scene.folder + "/desk.cookies";
  const std::string page = fmt::format("https://127.0.0.1:{}", kDeskPort);
  std::vector<std::string> words{"curl",     "--silent", "--insecure",      "--max-time", "20",
                                 "--output", answer,     "--cookie",        cookies,      "--cookie-jar",
                                 cookies,    "--header", "Origin: " + page, page + path};
  if (!body.empty()) words.insert(words.end(), {"--data-binary", body});
  const auto asked = RunToEnd(words, scene.folder + "/curl.log");
  return asked ? ReadFile(answer).value_or("") : "";
}

// The state of the box's list once it has these words. Errors: invalid_argument, it has not; with what it has.
Result<std::string> WantOnPage(Scene& scene, std::string_view words) {
  std::string state;
  const bool has = scene.target.Until(
      [&] {
        state = AskDesk(scene, "/box");
        return state.find(words) != std::string::npos;
      },
      kLongestPage);
  if (!has) return FailInput(fmt::format("the desk's page has no \"{}\": {}", words, state));
  return state;
}

// Types the code of the screen into the page.
Result<void> PairWithDesk(Scene& scene) {
  const auto board = scene.target.UntilBoard([](const BoardView& view) { return view.desk_code >= 0; },
                                             kLongestPage, "the screen shows no code of the desk");
  if (!board) return tl::unexpected(board.error());
  AskDesk(scene, "/pair", fmt::format("{:06}", board->desk_code));
  return {};
}

// Line 1 of the newest list, its second: "yes".
void SayYes(Scene& scene, const std::string& state) {
  constexpr std::string_view kList = "\"list\":";
  std::uint32_t list = 0;
  const std::size_t at = state.find(kList) + kList.size();
  std::from_chars(state.data() + at, state.data() + state.size(), list);
  AskDesk(scene, "/box", fmt::format("take 1 {}", list));
}

// Settings with a mistake are refused, and others are shown before they count: by the programs of the box in their sandboxes.
Result<void> ChangesSettings(Scene& scene) {
  const std::string fresh = std::string(kWithAddress) + "[stick.left]\ncurve = 0.4\n";
  if (auto ok = PairWithDesk(scene); !ok) return ok;
  if (auto ok = WantOnPage(scene, "settings of this box"); !ok) return tl::unexpected(ok.error());
  AskDesk(scene, "/box", "settings\nprofile = \"stag\"\n");
  if (auto ok = WantOnPage(scene, "there is no profile"); !ok) return tl::unexpected(ok.error());
  AskDesk(scene, "/box", "settings\n" + fresh);
  const auto asked = WantOnPage(scene, "new     stick.left.curve  0.4");
  if (!asked) return tl::unexpected(asked.error());
  SayYes(scene, *asked);
  if (auto ok = WantOnPage(scene, "switch the box off and on"); !ok) return tl::unexpected(ok.error());
  if (const std::string file = TextInBox(scene, "read /var/lib/kaori/settings/box.toml");
      file.find(fresh) == file.npos)
    return FailInput("the box's settings are \"" + file + "\"");
  return {};
}

// The bench's simulated devices stand still while another program runs, so the socket is awaited first.
Result<void> WantDesk(Scene& scene) {
  if (!scene.target.Until([&] { return Listens(scene); }, kLongestDesk)) {
    scene.finding.texts.emplace_back(
        "what the box logged of the desk",
        TextInBox(scene, "own /usr/bin/journalctl -b -n 300 --no-pager -o short-monotonic"));
    return FailInput("the service key is on, and no desk listens");
  }
  if (const std::string said = AskDesk(scene, "/hello"); said.find("\"paired\"") == std::string::npos)
    return FailInput("the desk answers a visitor with \"" + said + "\"");
  return scene.ShootFace("desk", "The desk's address and its code, while the service key is on");
}

// The key is turned back in each case, since the next check finds the bridge as it was left.
Result<void> IsThereWithTheKey(Scene& scene) {
  if (Listens(scene)) return FailInput("a desk listens though the service key is off");
  scene.target.rig().gpio().Close(kStickKey);
  auto ok = WantDesk(scene);
  if (ok) ok = ChangesSettings(scene);
  scene.target.rig().gpio().Open(kStickKey);
  if (ok && !scene.target.Until([&] { return !Listens(scene); }, kLongestDesk))
    ok = FailInput("the service key is off again, and the desk still listens");
  scene.finding.said =
      "a visitor of the box's network gets the desk while the service key is on, and nobody before and "
      "after; settings that were brought there are checked, shown and kept";
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
  if (ok) box.Off();
  return ok;
}

// As a visitor of the network, by HTTPS and nothing else.
Result<void> Desk(Scene& scene) {
  PlayStrategy box(scene.target);
  auto ok = box.Play(DeskSetup(kWithAddress));
  if (ok) ok = IsThereWithTheKey(scene);
  if (ok) box.Off();
  return ok;
}

}  // namespace

std::vector<Check> DeskChecks() {
  return {{"desk",
           "A box with an address lets a visitor of its network set it up while the service key is on",
           false,
           Desk,
           DeskSetup(kWithAddress),
           {},
           IsNotThereWithoutAnAddress,
           true}};
}

}  // namespace kaori::hil
