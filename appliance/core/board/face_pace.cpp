#include "appliance/core/board/face_pace.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "appliance/core/board/board.h"
#include "drivers/base/log.h"

namespace kaori::board {
namespace {

struct AskedBoard {
  std::string path;
  FacePace pace{};
  bool is_named = false;
};

// Any other error than a board that is not there would have the work go on for ever without a rest.
void NameOnce(AskedBoard& asked, const Error& error) {
  if (error.cause == std::errc::no_such_file_or_directory || std::exchange(asked.is_named, true)) return;
  LogWarning("{}; the work does not rest for the face", error.message());
}

}  // namespace

// Half of what was counted before stays after two turns: scenes of a show differ in what they cost.
void FacePace::Counted::Add(std::uint32_t more_frames, Duration in) {
  constexpr double kKeptOfBefore = 0.7;
  frames = kKeptOfBefore * frames + more_frames;
  s = kKeptOfBefore * s + Seconds(in);
}

void FacePace::Begin(std::uint32_t frames, Time now) {
  *this = {};
  began_ = now;
  frames_at_ = frames;
  length_ = kShortestTurn;
}

// A turn that ended between two frames would give a part of the next one's time to the other kind, always the same one.
bool FacePace::IsTurnOver(std::uint32_t frames, Time now) const {
  const Duration lasted = now - began_;
  const bool ends_with_frame = frames != frames_then_ && frames - frames_at_ >= kTurnFrames;
  return (lasted >= length_ && (ends_with_frame || !is_drawn_)) || lasted >= std::max(length_, kWaits);
}

// While it works the face loses 1 - working / resting of its frames; on the whole it loses share times that, which shall be
// 1 - kKept. Nothing is known before the first turn of work.
double FacePace::Share() const {
  constexpr double kAtFirst = 0.5;
  if (working_.s <= 0) return kAtFirst;
  const double loss = resting_.Rate() > 0 ? 1 - working_.Rate() / resting_.Rate() : 0;
  return loss > 0 ? std::clamp((1 - kKept) / loss, kLeastShare, kMostShare) : kMostShare;
}

void FacePace::Turn(std::uint32_t frames, Time now) {
  const Duration lasted = now - began_;
  (works_ ? working_ : resting_).Add(frames - frames_at_, lasted);
  if (!works_) is_drawn_ = frames != frames_at_;
  const double share = Share(), other = works_ ? (1 - share) / share : share / (1 - share);
  length_ =
      std::clamp(FromSeconds(Seconds(lasted) * other), kShortestTurn, works_ ? kLongestRest : kLongestWork);
  works_ = !works_;
  began_ = now;
  frames_at_ = frames;
}

// A stage that starts anew may count from the beginning.
bool FacePace::MayWork(std::uint32_t frames, Time now) {
  const bool is_new = asked_ == Time{} || now - asked_ > kForgets || frames < frames_at_;
  if (is_new)
    Begin(frames, now);
  else if (IsTurnOver(frames, now))
    Turn(frames, now);
  asked_ = now;
  frames_then_ = frames;
  return works_;
}

// A board that was made anew has nothing of the stage until that has moved there, and then as many frames as before.
std::function<bool()> PaceByBoardAt(std::string path) {
  return [asked = std::make_shared<AskedBoard>(AskedBoard{.path = std::move(path)})] {
    const auto board = Board::Open(asked->path);
    if (!board) NameOnce(*asked, board.error());
    const auto status = board ? board->Read<StageStatus>() : Stamped<StageStatus>{};
    return status.source == SourceState::kAbsent ||
           asked->pace.MayWork(status.value.frames, SteadyClock().now());
  };
}

}  // namespace kaori::board
