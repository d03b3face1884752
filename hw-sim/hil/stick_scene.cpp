#include "hw-sim/hil/stick_scene.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr Duration kStickAnswer = seconds(60);
// Without another word or percent: at a tenth of the time of an emulated machine, which is what the face may leave it, an update was 21
// minutes.
constexpr Duration kLongestStandstill = minutes(10);
constexpr Duration kLongestChange = minutes(5);  // Until the stage draws with another show.
// QEMU's vendor and product; behind it whether it is authorised.
constexpr const char* kStickNumber = "46f4:0001 ";
// Of lines that the list has while a stick is in.
constexpr std::string_view kOntoStick = "onto the stick";
// Of each message on something that is copied, checked, read or written.
constexpr std::string_view kWorks = " is being ";
constexpr int kMostPresses = 3;

// The key of the list's line with these words: its number, 1 to 9, or 0 for the tenth, which follows on 9 on a keyboard. Errors:
// invalid_argument, there is none.
Result<std::uint8_t> KeyOfLine(Scene& scene, std::string_view words) {
  const std::string said = TextInBox(scene, kSaid);
  const std::size_t at = said.find(words);
  const std::size_t number =
      at == std::string::npos ? at : said.find_first_of("123456789", said.rfind('\n', at) + 1);
  if (number >= at) return FailInput(fmt::format("the list has no \"{}\", but says \"{}\"", words, said));
  const bool is_tenth = said.compare(number, 2, "10") == 0;
  return static_cast<std::uint8_t>(is_tenth ? kOne + 9 : kOne + (said[number] - '1'));
}

}  // namespace

// With a disk of its own what the box keeps outlives a restart; without one nothing of it does.
Setup StickSetup(const std::string& disk) {
  return {.sound = false, .keeps_disk = !disk.empty(), .width_px = 480, .height_px = 270, .disk = disk};
}

// An agent that does not answer says nothing: whoever waits for a text asks again.
std::string TextInBox(Scene& scene, const std::string& question) {
  return scene.target.agent().Ask(question, kStickAnswer).value_or("");
}

// No answer is nothing new.
Result<void> UntilSaid(Scene& scene, const std::function<bool(const std::string&)>& right,
                       const std::function<std::string()>& look) {
  std::string said, before;
  const auto is_new = [&] {
    if (std::string heard = look ? look() : TextInBox(scene, kSaid); !heard.empty()) said = std::move(heard);
    return std::exchange(before, said) != said;
  };
  static_cast<void>(is_new());
  while (!right(said))
    if (!scene.target.Until(is_new, kLongestStandstill))
      return FailInput("what the stick brings does not go on, and the box says \"" + said + "\"");
  return {};
}

Result<void> WantStickSaid(Scene& scene, std::string_view words, Duration longest) {
  std::string said;
  const auto says = [&] {
    said = TextInBox(scene, kSaid);
    return said.find(words) != std::string::npos;
  };
  if (scene.target.Until(says, longest)) return {};
  return FailInput(fmt::format("the box does not say \"{}\" of the stick, but \"{}\"", words, said));
}

// Write-protected: a stick of the bench is the same for each check.
Result<void> Plug(Scene& scene, const std::string& stick) {
  return scene.target.machine().PlugStick(scene.target.machine().options().sticks + "/" + stick, false);
}

// A key that is pressed while the list changes is of the list before, or of none: it is pressed again, thrice at most.
Result<void> PressFor(Scene& scene, std::uint8_t key, std::string_view words) {
  Result<void> said;
  for (int n = 0; n < kMostPresses; ++n) {
    scene.target.For(seconds(3));
    scene.TapKey(key);
    said = WantStickSaid(scene, words, seconds(60));
    if (said) break;
  }
  return said;
}

// A key that is pressed once more behind what it asked for would ask for it again, with another answer: only a line that the list still
// has, and that nobody works on, is pressed.
Result<void> ChooseLine(Scene& scene, std::string_view line, std::string_view answer, Duration longest) {
  if (auto ok = WantStickSaid(scene, line, kLongestReading); !ok) return ok;
  const auto is_taken = [&] {
    const std::string said = TextInBox(scene, kSaid);
    return !said.empty() && (said.find(line) == said.npos || said.find(kWorks) != said.npos);
  };
  bool taken = false;
  for (int n = 0; n < kMostPresses && !taken; ++n) {
    scene.target.For(seconds(3));
    const auto key = KeyOfLine(scene, line);
    if (!key) return tl::unexpected(key.error());
    scene.TapKey(*key);
    taken = scene.target.Until(is_taken, seconds(60));
  }
  return WantStickSaid(scene, answer, longest);
}

Result<std::string> ChosenId(Scene& scene) {
  const std::string choice = TextInBox(scene, "read /var/lib/kaori/shows/choice.1");
  // The file's lines are a word and a value each (appliance/core/store/choice.h).
  constexpr std::string_view kWord = "\ncurrent ";
  const std::size_t at = choice.find(kWord);
  if (at == std::string::npos) return FailInput("no show is chosen on the box");
  const std::size_t begin = at + kWord.size();
  return choice.substr(begin, choice.find('\n', begin) - begin);
}

// The stage notes which show it plays before it draws; both are waited for, and a frame that was drawn since.
Result<void> WantPlayed(Scene& scene, const std::string& id) {
  const auto noted = [&] {
    return TextInBox(scene, "read /run/kaori/plays").find("playing " + id) != std::string::npos;
  };
  if (!scene.target.Until(noted, kLongestChange)) return FailInput("the stage does not play the chosen show");
  const auto now = scene.target.Board();
  const auto draws = [&](const BoardView& board) {
    return board.stage.live && board.stage.frames > 1 && (!now || board.stage.read_ns > now->now_ns);
  };
  if (auto seen = scene.target.UntilBoard(draws, kLongestChange, "see the chosen show drawn"); !seen)
    return tl::unexpected(seen.error());
  return {};
}

// The lines go with kaori-shows; the kernel is told by udev once that has ended.
Result<void> WantDead(Scene& scene) {
  const auto dead = [&] {
    return TextInBox(scene, kSaid).empty() &&
           TextInBox(scene, "usb").find(std::string(kStickNumber) + "0") != std::string::npos;
  };
  return scene.target.Until(dead, kLongestReading)
             ? Result<void>{}
             : FailInput("the stick is alive after the key was turned back");
}

Result<void> WantListGone(Scene& scene) {
  const auto gone = [&] { return TextInBox(scene, kSaid).find(kOntoStick) == std::string::npos; };
  return scene.target.Until(gone, kLongestReading) ? Result<void>{}
                                                   : FailInput("the list of the pulled stick stays");
}

Result<void> InService(Scene& scene, const char* disk, const std::function<Result<void>()>& what) {
  const QemuOptions& options = scene.target.machine().options();
  std::string file;
  if (disk != nullptr) {
    auto copy = CopyDisk(options.image + "/kaori.disk", options.folder, disk, "data");
    if (!copy) return tl::unexpected(copy.error());
    file = copy->file;
  }
  PlayStrategy box(scene.target);
  auto ok = box.Play(StickSetup(file));
  scene.target.rig().gpio().Close(kStickKey);
  if (ok) ok = what();
  scene.target.rig().gpio().Open(kStickKey);
  static_cast<void>(scene.target.machine().PullUnauthorised());
  if (ok) box.Off();
  if (!file.empty()) std::filesystem::remove(file);
  return ok;
}

Result<std::string> PlugEmptyStick(Scene& scene, const std::string& name) {
  std::string stick = scene.folder + "/" + name + ".stick";
  std::error_code failed;
  std::filesystem::copy_file(scene.target.machine().options().sticks + "/empty.stick", stick,
                             std::filesystem::copy_options::overwrite_existing, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "copy the empty stick");
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return tl::unexpected(ok.error());
  if (auto ok = WantListGone(scene); !ok) return tl::unexpected(ok.error());
  if (auto ok = scene.target.machine().PlugStick(stick, true); !ok) return tl::unexpected(ok.error());
  return stick;
}

// The stick has a show and the key that signed it, in that order of the list; the show is refused until its key is there.
Result<void> BringKey(Scene& scene, const std::string& show) {
  if (auto ok = Plug(scene, show + ".stick"); !ok) return ok;
  if (auto ok = WantStickSaid(scene, "> 1. " + show + "  ", kLongestReading); !ok) return ok;
  if (auto ok = WantStickSaid(scene, "  2. key theatre  ", seconds(5)); !ok) return ok;
  if (auto ok = PressFor(scene, kOne, show + ": this box "); !ok) return ok;
  if (auto ok = PressFor(scene, kTwo, "  2. yes, trust this key"); !ok) return ok;
  return PressFor(scene, kTwo, "theatre: this key is on the box now");
}

}  // namespace kaori::hil
