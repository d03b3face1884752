#include "appliance/programs/stage/last_face.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <utility>

#include "appliance/core/board/performance_state.h"
#include "appliance/core/performance/recall.h"
#include "appliance/programs/stage/last_face_writer.h"
#include "drivers/base/log.h"
#include "firmware/wire/last_face.h"

namespace kaori::stage {
namespace {

constexpr Duration kBetween = std::chrono::seconds(30);
constexpr float kBlinkOver_s = 0.6F;
constexpr float kOpenLids = 0.1F;

Result<std::vector<std::uint8_t>> ReadBytes(const std::filesystem::path& path, std::size_t most) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return FailErrno("read " + path.string());
  std::vector<std::uint8_t> bytes(most);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::optional<performance::State> StateIn(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLayout = sizeof(std::uint32_t);
  board::Performance held;
  if (bytes.size() < kLayout || bytes.size() - kLayout > held.state.size()) return std::nullopt;
  held.layout = wire::GetU32(bytes, 0);
  held.bytes = static_cast<std::uint32_t>(bytes.size() - kLayout);
  std::ranges::copy(bytes.subspan(kLayout), held.state.begin());
  return board::Restore<performance::State>(held);
}

bool Done(const performance::State& state) {
  const auto done = [](const performance::Mixture* mixture) { return mixture->progress >= 1; };
  return std::ranges::all_of(std::array{&state.faces, &state.expressions, &state.styles, &state.backdrops},
                             done) &&
         (state.backstage.duration_s <= 0 || state.backstage.progress >= 1);
}

// A picture that one likes to look at for a second: nothing is on its way, and the eyes are open.
bool IsCalm(const performance::State& state, const scene::Scene& scene) {
  const auto plays = [](const performance::Playing& voice) { return voice.motion >= 0; };
  const auto shut = [](float lids) { return lids > kOpenLids; };
  return Done(state) && std::ranges::none_of(state.voices, plays) &&
         std::ranges::min(state.blink_s) > kBlinkOver_s &&
         std::ranges::none_of(scene.weights.lids_shut, shut);
}

bool IsFit(const performance::State& state, const scene::Scene& scene) {
  return state.blackout <= 0 && !(scene.caption.shown > 0);
}

}  // namespace

Result<std::uint64_t> ShowMark(const std::filesystem::path& pack) {
  const auto bytes = ReadBytes(pack, wire::kShowMark_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return wire::AddSum(wire::kEmptySum, *bytes);
}

Result<performance::State> RecallLastFace(const LastFaceFile& where, const show::Show& show,
                                          const board::Snapshot& board, Time presented_at) {
  const auto bytes = ReadBytes(where.file, wire::kLargestLastFace_bytes + 1);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto refuse = [&](const char* why) {
    return FailInput("go on from " + where.file.string() + ": " + why);
  };
  const auto face = wire::ReadLastFace(*bytes);
  if (!face) return refuse("it is torn");
  if (face->show != where.show) return refuse("it is of another show");
  const auto state = StateIn(face->state);
  if (!state || !performance::IsValid(*state, show)) return refuse("it is of another version");
  return performance::Recalled(*state, board, presented_at);
}

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

LastFace::LastFace(LastFaceFile where, Look look, const std::optional<performance::State>& recalled)
    : look_(std::move(look)), writer_(std::make_unique<Writer>(std::move(where))) {
  if (recalled) kept_ = CalledOf(*recalled);
}

LastFace::~LastFace() = default;

LastFace::Called LastFace::CalledOf(const performance::State& state) {
  return {.items = {state.faces.to, state.expressions.to, state.styles.to, state.backdrops.to, state.scene},
          .knobs = state.knobs};
}

void LastFace::Observe(const performance::State& state, const scene::Scene& scene, Time now) {
  seen_ = state;
  fit_ = IsFit(state, scene);
  if (std::exchange(first_, false)) return;  // It must be on the screen soon: copying it out comes after.
  if (now < not_before_ || !fit_ || !IsCalm(state, scene)) return;
  if (writer_->failed()) kept_.reset();
  if (kept_ == CalledOf(state) || !Keep()) return;
  not_before_ = now + kBetween;
}

bool LastFace::Keep() {
  SmallImage* const into = writer_->idle();
  if (into == nullptr || !look_(*into)) return false;
  kept_ = CalledOf(seen_);
  writer_->Write(board::Hold(seen_));
  return true;
}

void LastFace::Finish() {
  writer_->Finish();
}

void LastFace::KeepNow() {
  if (!fit_) return;
  Finish();
  Keep();
  Finish();
}

}  // namespace kaori::stage
