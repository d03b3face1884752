// The box comes back with its last face after its plug was pulled.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/start_times.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

constexpr Duration kLongestScene = seconds(240);
// A change is kept within half a minute; but a frame may take seconds here, and a fade needs ten.
constexpr Duration kLongestKeep = seconds(900);
constexpr Duration kNamed = seconds(5);    // From the file's bytes on the disk to its name.
constexpr std::uint8_t kPosterKey = 0x3B;  // F2, which calls another scene.
constexpr double kSameLook = 0.05;         // As far as a face moves by itself.
constexpr double kOtherLook = 0.12;        // At least so far are two scenes apart.
constexpr std::string_view kEnd =
    "KAORI LF";  // The end of a last face's file begins so (appliance/core/last_face/last_face.h).

// Without its devices the face moves by itself alone, which two pictures of one scene may differ by.
Setup SetupOf(const std::string& disk, bool agent) {
  return {.plugged = false,
          .sound = false,
          .agent = agent,
          .keeps_disk = true,
          .width_px = 480,
          .height_px = 270,
          .disk = disk};
}

// The box's data partition, on a copy of its disk that keeps what is written.
class KeptDisk {
 public:
  // Errors: those of CopyDisk.
  static Result<KeptDisk> Copy(const QemuOptions& options) {
    const auto copy = CopyDisk(options.image + "/kaori.disk", options.folder, "kept.disk", "data");
    if (!copy) return tl::unexpected(copy.error());
    return KeptDisk(copy->file, copy->start_bytes);
  }
  const std::string& file() const { return file_; }

  // Where each last face on it ends, those that were replaced too, and what that end says.
  std::map<std::uint64_t, std::string> Faces() const {
    // All of the partition is read: files that were replaced are in no folder any more.
    constexpr std::size_t kEndBytes = 32;
    std::ifstream file(file_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(data_));
    std::string bytes(std::filesystem::file_size(file_) - data_, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::boyer_moore_horspool_searcher search(kEnd.begin(), kEnd.end());
    std::map<std::uint64_t, std::string> found;
    for (auto at = bytes.begin(); (at = std::search(at, bytes.end(), search)) != bytes.end(); ++at) {
      const auto offset = static_cast<std::size_t>(at - bytes.begin());
      found[data_ + offset] = bytes.substr(offset, kEndBytes);
    }
    return found;
  }

  // The ends by what they say, which holds a checksum: another face has another one.
  std::set<std::string> Marks() const {
    std::set<std::string> marks;
    for (const auto& [at, mark] : Faces()) marks.insert(mark);
    return marks;
  }

  // Changes the last byte of the state in each of them.
  void Spoil() const {
    std::fstream file(file_, std::ios::binary | std::ios::in | std::ios::out);
    for (const auto& [end, mark] : Faces()) {
      file.seekg(static_cast<std::streamoff>(end - 1));
      const int byte = file.get();
      file.seekp(static_cast<std::streamoff>(end - 1));
      file.put(static_cast<char>(byte ^ 0xFF));
    }
  }

 private:
  KeptDisk(std::string file, std::uint64_t data) : file_(std::move(file)), data_(data) {}
  std::string file_;
  std::uint64_t data_;  // Where the data partition begins, in bytes.
};

// The pictures of an evening, in the folder for sockets: the control looks at them too.
struct Evening {
  std::string opening, last;  // The show's first face, and the one on the screen when the plug is pulled.
};

Evening EveningOf(Scene& scene) {
  const std::string& folder = scene.target.machine().options().folder;
  return {folder + "/opening.png", folder + "/evening.png"};
}

Result<double> LookApart(Scene& scene, const std::string& one, const std::string& now) {
  if (auto ok = scene.target.machine().Shoot(0, now); !ok) return tl::unexpected(ok.error());
  return MeanDifference(one, now);
}

// New is a mark that was not on the disk before; after the bytes the box still has to name the file.
Result<void> AwaitNewFace(Scene& scene, const KeptDisk& disk, const std::set<std::string>& before) {
  const auto kept = [&] {
    scene.target.For(seconds(2));  // To look at the disk takes the machine's time.
    return !std::ranges::includes(before, disk.Marks());
  };
  if (auto ok = scene.target.Await(kept, kLongestKeep, "see the face kept on the disk"); !ok) return ok;
  scene.target.For(kNamed);
  return {};
}

// A key calls another scene; once that is kept the plug is pulled.
Result<void> PlayEvening(Scene& scene, const KeptDisk& disk) {
  const auto [opening, last] = EveningOf(scene);
  PlayStrategy box(scene.target);
  if (auto ok = box.Play(SetupOf(disk.file(), true)); !ok) return ok;
  if (auto ok = scene.target.machine().Shoot(0, opening); !ok) return ok;
  if (auto ok = scene.target.rig().Plug("keyboard"); !ok) return ok;
  const auto keys = [](const BoardView& board) { return board.keys_live; };
  if (auto ok = scene.target.UntilBoard(keys, kLongestScene, "find the keyboard"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = AwaitNewFace(scene, disk, {}); !ok) return ok;
  const auto before = disk.Marks();
  scene.TapKey(kPosterKey);
  const auto other = [&, &opening = opening, &last = last] {
    const auto apart = LookApart(scene, opening, last);
    return apart && *apart >= kOtherLook;
  };
  auto ok = scene.target.Await(other, kLongestScene, "see the other scene that the key calls");
  if (ok) ok = AwaitNewFace(scene, disk, before);
  if (ok) ok = scene.target.machine().Shoot(0, last);
  box.Off();
  return ok;
}

// How far the first picture and the first face after power are from another one.
struct Return {
  double light = 0, face = 0;
  double light_s = 0;
};

Result<Return> StartAgain(Scene& scene, const std::string& disk, const std::string& expected,
                          const char* name) {
  const std::string light = fmt::format("{}/last-face-{}-light.png", scene.folder, name);
  const std::string face = fmt::format("last-face-{}.png", name);
  const Time began = scene.target.clock().now();
  if (auto ok = scene.SwitchOn(SetupOf(disk, false)); !ok) return tl::unexpected(ok.error());
  const auto times = AwaitStart(scene.target, began, light);
  if (!times) return tl::unexpected(times.error());
  const auto face_apart = LookApart(scene, expected, scene.folder + "/" + face);
  const auto light_apart = MeanDifference(expected, light);
  if (!face_apart || !light_apart)
    return tl::unexpected(face_apart ? light_apart.error() : face_apart.error());
  scene.finding.pictures.push_back({face, fmt::format("The first face, {}", name)});
  return Return{*light_apart, *face_apart, times->light_s};
}

// Of two starts, between which the power was off.
Result<void> WantSame(const Return& found, const char* what) {
  if (std::max(found.light, found.face) <= kSameLook) return {};
  return FailInput(
      fmt::format("{}: the first picture differs by {:.3f}, the first face by {:.3f} (at most {})", what,
                  found.light, found.face, kSameLook));
}

Result<void> ComesBack(Scene& scene, const std::string& disk) {
  const auto [opening, last] = EveningOf(scene);
  const auto found = StartAgain(scene, disk, last, "kept");
  if (!found) return tl::unexpected(found.error());
  const auto apart = MeanDifference(opening, scene.folder + "/" + scene.finding.pictures.back().file);
  scene.target.machine().Off();
  if (!apart) return tl::unexpected(apart.error());
  scene.finding.figures["last_face_light"] = found->light;
  scene.finding.figures["last_face_face"] = found->face;
  scene.finding.said = fmt::format(
      "first picture after {:.1f} s; from the evening's it differs by {:.3f}, the first face by {:.3f}, "
      "which differs by "
      "{:.3f} from the show's first",
      found->light_s, found->light, found->face, *apart);
  if (*apart < kOtherLook) return FailInput("the box came back with the show's first face");
  return WantSame(*found, "the evening's face");
}

// The show's first face comes, and the log says why.
Result<void> TornIsRefused(Scene& scene, const KeptDisk& disk) {
  disk.Spoil();
  const auto found = StartAgain(scene, disk.file(), EveningOf(scene).opening, "torn");
  const bool named = scene.target.UntilConsole({"last-face", "it is torn"}, seconds(60));
  scene.target.machine().Off();
  if (!found) return tl::unexpected(found.error());
  scene.finding.said +=
      fmt::format("; torn, the first picture differs from the show's first by {:.3f}, the face by {:.3f}",
                  found->light, found->face);
  if (!named) return FailInput("a torn last face is not named in the log");
  return WantSame(*found, "the show's first face after a torn file");
}

// An evening, then its return, then a torn file: all on one copy of the disk, which is removed in each case.
Result<void> LastFace(Scene& scene) {
  const auto disk = KeptDisk::Copy(scene.target.machine().options());
  if (!disk) return tl::unexpected(disk.error());
  auto ok = PlayEvening(scene, *disk);
  if (ok) ok = ComesBack(scene, disk->file());
  if (ok) ok = TornIsRefused(scene, *disk);
  scene.target.machine().Off();
  std::filesystem::remove(disk->file());
  return ok;
}

// The control: a disk that keeps nothing does not bring the evening's face back.
Result<void> EmptyDataComeBackOtherwise(Scene& scene) {
  const auto disk = KeptDisk::Copy(scene.target.machine().options());
  if (!disk) return tl::unexpected(disk.error());
  const auto back = ComesBack(scene, disk->file());
  std::filesystem::remove(disk->file());
  return WantFoundWrong(back, "the evening's face is seen although nothing was kept");
}

}  // namespace

std::vector<Check> LastFaceChecks() {
  return {{"last-face",
           "The last face comes back with the power",
           false,
           LastFace,
           SetupOf("", true),
           {},
           EmptyDataComeBackOtherwise,
           true}};
}

}  // namespace kaori::hil
