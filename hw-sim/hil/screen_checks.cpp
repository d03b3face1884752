// What is on the screen, while it plays and while its program is away.
#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// A stage that comes back reads its show again, on a busy machine.
constexpr Duration kLongestReturn = seconds(240);
constexpr Duration kScreenLongestFrame = seconds(300);  // With a new style's shaders, on a busy machine.
// Pictures over some seconds, from the kill on.
constexpr int kShotsWhileAway = 12;

// The picture that was added to the finding last.
Result<PictureView> LastPicture(const Scene& scene) {
  return LookAt(scene.folder + "/" + scene.finding.pictures.back().file);
}

// The speed is that of a processor that draws by itself and is emulated: it says
// little, and is compared with itself.
Result<void> Face(Scene& scene) {
  if (auto ok = scene.ShootFace("face", "The first face"); !ok) return ok;
  const auto picture = LastPicture(scene);
  if (!picture) return tl::unexpected(picture.error());
  const auto board = scene.target.Board();
  if (!board) return tl::unexpected(board.error());
  scene.finding.figures["llvmpipe_frames_per_s"] = board->stage.frames_per_s;
  scene.finding.said = fmt::format("{}; {:.1f} frames/s", Describe(*picture), board->stage.frames_per_s);
  return {};
}

// The control of every check that looks for a face: a black picture of the same size shows none.
Result<void> BlackIsNoFace(Scene& scene) {
  if (auto ok = scene.ShootFace("control", "Not yet black"); !ok) return ok;
  const std::string black = scene.folder + "/control-black.png";
  if (auto ok = WriteBlack(scene.folder + "/" + scene.finding.pictures.back().file, black); !ok) return ok;
  const auto picture = LookAt(black);
  if (!picture) return tl::unexpected(picture.error());
  return ShowsAFace(*picture) ? FailInput("a black picture shows a face") : Result<void>{};
}

// Without input the face moves by itself, and devices that are plugged in later are used.
Result<void> Alone(Scene& scene) {
  constexpr double kMoved = 0.002;  // Of the points.
  constexpr std::uint32_t kFrames = 4;
  if (auto ok = scene.ShootFace("alone", "Nothing is plugged in"); !ok) return ok;
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const auto later = [&](const BoardView& board) {
    return board.stage.live && board.stage.frames >= before->stage.frames + kFrames;
    // Frames are waited for, not seconds: a slow machine moves as far in as many frames.
  };
  if (auto ok = scene.target.UntilBoard(later, kScreenLongestFrame, "see it play alone"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = scene.ShootFace("alone", "A little later"); !ok) return ok;
  const auto moved = ChangedPart(scene.folder + "/" + scene.finding.pictures[0].file,
                                 scene.folder + "/" + scene.finding.pictures[1].file);
  if (!moved) return tl::unexpected(moved.error());
  if (*moved < kMoved) return FailInput("nothing moves");
  // The box has played without them: now they come one after another.
  if (auto ok = scene.target.PlugAll(); !ok) return ok;
  const auto found = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.lips_live;
  };
  if (auto ok = scene.target.UntilBoard(found, kLongestReturn, "find what is plugged in at last"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = fmt::format(
      "the face moved by itself ({:.1f} % of the points), then took what was plugged in", 100 * *moved);
  return {};
}

// The kernel keeps the last picture; systemd starts the program again. The kernel keeps a framebuffer as
// long as the fd keeper has the card's file.
Result<void> StageKilled(Scene& scene) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const Time killed = scene.target.clock().now();
  if (const auto found = scene.target.agent().Ask("signal kaori-stage 9", seconds(60));
      !found || *found != "1")
    return FailInput("the stage could not be killed");
  for (int n = 0; n < kShotsWhileAway; ++n) {
    if (auto ok = scene.ShootFace(
            "killed", fmt::format("{:.1f} s after the kill", Seconds(scene.target.clock().now() - killed)));
        !ok)
      return ok;
    if (n > 0 && n + 1 < kShotsWhileAway)
      scene.finding.pictures.pop_back();  // The first and the last are shown.
    scene.target.For(std::chrono::milliseconds(150));
  }
  const auto returned = [&](const BoardView& board) {
    // Another count of frames: fewer of a new program, or more where it was back between two looks.
    return board.stage.live && board.stage.frames != before->stage.frames &&
           board.now_ns - before->now_ns > 0;
  };
  if (auto ok = scene.target.UntilBoard(returned, kLongestReturn, "wait for the stage to come back"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = fmt::format("a face on all {} pictures; back after {:.1f} s", kShotsWhileAway,
                                   Seconds(scene.target.clock().now() - killed));
  return {};
}

}  // namespace

// Both look for a face, so their control is a picture without one.
std::vector<Check> ScreenChecks() {
  return {{"face", "The face is on the screen", true, Face, {}, {}, BlackIsNoFace},
          {.name = "stage-killed",
           .sentence = "The stage is killed: its last picture stays, and it comes back",
           .chosen = true,
           .run = StageKilled,
           .control = BlackIsNoFace,
           .ends_programs = true}};
}

std::vector<Check> AloneChecks() {
  return {{"alone",
           "Without any device it plays by itself",
           false,
           Alone,
           {.plugged = false, .sound = false},
           "kaori-stage.service"}};
}

}  // namespace kaori::hil
