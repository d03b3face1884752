#include "appliance/programs/stage/last_face.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/last_face/last_face.h"
#include "appliance/core/performance/motions.h"
#include "appliance/core/performance/recall.h"
#include "appliance/programs/stage/last_face_writer.h"
#include "drivers/base/checksum.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

// Between two writings, which wear the disk; a scene that is called meanwhile is kept when it is over.
constexpr Duration kBetween = std::chrono::seconds(30);
// Between two questions whether a trial is over.
constexpr Duration kBetweenQuestions = std::chrono::seconds(1);
// Seconds after the beginning of a blink (0.26 s long) from which on the eyes look awake, and the shut part
// of a lid, 0..1, up to which they count as open.
constexpr float kBlinkOver_s = 0.6F;
constexpr float kOpenLids = 0.1F;
// A motion is waited for, but not longer than this: one that loops has no end.
constexpr Duration kMotionWait = std::chrono::seconds(10);

// The state as LastFace::Writer puts it: the layout's number, then the bytes of performance::State.
std::optional<performance::State> StateIn(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLayout = sizeof(std::uint32_t);
  board::Performance held;
  if (bytes.size() < kLayout || bytes.size() - kLayout > held.state.size()) return std::nullopt;
  held.layout = wire::GetU32(bytes, 0);
  held.bytes = static_cast<std::uint32_t>(bytes.size() - kLayout);
  std::ranges::copy(bytes.subspan(kLayout), held.state.begin());
  return board::Restore<performance::State>(held);
}

// Whether no fade of face, expression, style, backdrop or light is under way, and no button held that lets
// something join: it will not be held tomorrow.
bool Done(const performance::State& state) {
  const auto done = [](const auto* one) { return one->progress >= 1; };
  const auto lasts = [](const performance::Kept& kept) {
    return kept.progress >= 1 && kept.call.mode != show::CallMode::kMomentary;
  };
  return std::ranges::all_of(MixturesOf(state), done) && std::ranges::all_of(FadingsOf(state), done) &&
         std::ranges::all_of(state.kept, lasts);
}

bool PlaysMotion(const performance::State& state) {
  return std::ranges::any_of(state.voices,
                             [](const performance::Playing& voice) { return voice.motion >= 0; });
}

// A picture that one likes to look at for a second: nothing is on its way, and the eyes are open.
bool IsCalm(const performance::State& state, const scene::Scene& scene) {
  const auto shut = [](float lids) { return lids > kOpenLids; };
  return Done(state) && std::ranges::min(state.blink_s) > kBlinkOver_s &&
         std::ranges::none_of(scene.weights.lids_shut, shut);
}

// Neither a blackout nor words on the screen shall greet whoever switches the box on.
bool IsFit(const performance::State& state, const scene::Scene& scene) {
  return state.blackout <= 0 && !(scene.caption.shown > 0);
}

}  // namespace

// The checks go from the bytes to the meaning: the file's own sum, the show it belongs to, the layout of this
// build, then every field. A state of another version is refused and not converted.
Result<performance::State> RecallLastFace(const LastFaceFile& where, const show::Show& show,
                                          const board::Snapshot& board, Time presented_at) {
  const auto bytes = ReadBeginning(where.file, last_face::kLargest_bytes + 1);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto refuse = [&](const char* why) {
    return FailInput("go on from " + where.file.string() + ": " + why);
  };
  const auto face = last_face::Read(AsBytes(*bytes));
  if (!face) return refuse("it is torn");
  if (face->show != where.show) return refuse("it is of another show");
  const auto state = StateIn(face->state);
  if (!state || !performance::IsValid(*state, show)) return refuse("it is of another version");
  performance::State recalled = performance::Recalled(*state, board, presented_at);
  // Where the list stands, motions play on: they begin once more.
  const auto stands = static_cast<std::size_t>(recalled.cue_run.active) + 1;
  if (const auto& tracked = show.cue_list.tracked; stands < tracked.size())
    for (const show::TrackedLoop& loop : tracked[stands].loops)
      performance::PlayMotion(recalled, show, loop.motion, loop.use);
  return recalled;
}

// A board that has a state is newer than any disk: there the stage was restarted, and not the box.
std::optional<performance::State> ResumeLastFace(const LastFaceFile& where, const show::Show& show,
                                                 const board::Board& board,
                                                 board::Writer<board::Performance>& writer,
                                                 Time presented_at) {
  if (board.Read<board::Performance>().source != board::SourceState::kAbsent) return std::nullopt;
  const auto state = RecallLastFace(where, show, board::ReadAll(board), presented_at);
  if (!state) {
    if (state.error().cause != std::errc::no_such_file_or_directory)
      LogWarning("{}", state.error().message());
    return std::nullopt;
  }
  writer.Write(board::Hold(*state), presented_at, board::SourceState::kLive);
  return *state;
}

// What was recalled is what lies on the disk, so that a show in which nobody touches anything writes nothing.
LastFace::LastFace(LastFaceFile where, Look look, IsOnTrial is_on_trial,
                   const std::optional<performance::State>& recalled)
    : look_(std::move(look)),
      is_on_trial_(std::move(is_on_trial)),
      writer_(std::make_unique<Writer>(std::move(where))) {
  if (recalled) kept_ = CalledOf(*recalled);
}

LastFace::~LastFace() = default;

// Dials are compared as they are set, not as they are shown, since those follow for seconds.
LastFace::Called LastFace::CalledOf(const performance::State& state) {
  Called called{.items = {state.faces.to, state.expressions.to, state.styles.to, state.backdrops.to,
                          state.scene, state.sheet},
                .knobs = state.knobs};
  for (std::size_t i = 0; i < state.kept.size(); ++i)
    if (const performance::Kept& kept = state.kept[i];
        kept.on != 0 && kept.call.mode == show::CallMode::kToggle)
      called.toggles[i] = kept.call;
  return called;
}

// A writing that failed is tried again: what was thought to be kept is forgotten.
void LastFace::Observe(const performance::State& state, const scene::Scene& scene, Time now) {
  seen_ = state;
  fit_ = IsFit(state, scene);
  if (first_ || !PlaysMotion(state)) still_at_ = now;
  if (std::exchange(first_, false)) return;  // It must be on the screen soon: copying it out comes after.
  const bool waits = now > still_at_ && now < still_at_ + kMotionWait;
  if (now < not_before_ || waits || !fit_ || !IsCalm(state, scene)) return;
  if (writer_->failed()) kept_.reset();
  if (kept_ == CalledOf(state)) return;
  if (is_on_trial_())
    not_before_ = now + kBetweenQuestions;
  else if (Keep())
    not_before_ = now + kBetween;
}

// The picture is read back from the graphics card here, on the stage's thread; only the disk is left to the
// other one. `kept_` is set before the disk has it, so that a slow disk is asked once.
bool LastFace::Keep() {
  SmallImage* const into = writer_->idle();
  if (into == nullptr || !look_(*into)) return false;
  kept_ = CalledOf(seen_);
  writer_->Write(board::Hold(seen_));
  return true;
}

// Blocks until the disk has what was asked for.
void LastFace::Finish() {
  writer_->Finish();
}

// Waits twice: for the writing that may be under way, since its buffers are in use, and for the new one.
void LastFace::KeepNow() {
  if (!fit_ || is_on_trial_()) return;
  Finish();
  Keep();
  Finish();
}

}  // namespace kaori::stage
