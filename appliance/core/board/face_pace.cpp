#include "appliance/core/board/face_pace.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "appliance/core/board/board.h"

namespace kaori::board {

// Half of what was counted before stays after four turns: scenes of a show differ in what they cost.
void FacePace::Counted::Add(std::uint32_t more_frames, Duration in) {
  constexpr double kKeptOfBefore = 0.85;
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
  return (lasted >= length_ && ends_with_frame) || lasted >= std::max(length_, kWaits);
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
  const double share = Share(), other = works_ ? (1 - share) / share : share / (1 - share);
  length_ = std::clamp(FromSeconds(Seconds(lasted) * other), kShortestTurn, kLongestTurn);
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

std::function<bool()> PaceByBoardAt(std::string path) {
  return [path = std::move(path), pace = std::make_shared<FacePace>()] {
    const auto board = Board::Open(path);
    return !board || pace->MayWork(board->Read<StageStatus>().value.frames, SteadyClock().now());
  };
}

}  // namespace kaori::board
