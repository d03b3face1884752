#include "tests/appliance/programs/lips_faults.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/mouth.h"
#include "appliance/programs/lips/lip_reader.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::lips {
namespace {

using std::chrono::milliseconds;

constexpr Duration kStep = milliseconds(5);
constexpr Duration kTick = milliseconds(25);  // Of kaori-lips, where no frame wakes it.
constexpr Duration kStageFrame = std::chrono::nanoseconds(16'666'667);
constexpr Duration kQuiet = milliseconds(1500);  // At least, between two faults.
constexpr Duration kShortest = milliseconds(300);
constexpr Duration kLongest = milliseconds(2600);
constexpr float kVoiceOpen = 0.05F;
constexpr float kNear = 0.1F;  // Of the mouth's opening.

double Milliseconds(Duration time) {
  return 1e3 * Seconds(time);
}

// The stage's mouth: lips and voice, mixed as it mixes them.
class StageMouth {
 public:
  // The mouth at the light of the next frame.
  float Move(board::Snapshot board, Time now) {
    state_.last = now + kStageFrame;
    board.voice.at = now;
    board.voice.source = board::SourceState::kLive;
    board.voice.value.height = kVoiceOpen;
    board.voice.value.width = 0.5F;
    face::Weights weights;
    MoveMouth(state_, board, channels_, weights, static_cast<float>(Seconds(kStageFrame)));
    return state_.mouth_open;
  }

 private:
  performance::State state_;
  show::Channels channels_;
};

class FaultPlay {
 public:
  FaultPlay(const Evening& evening, SpoiltCamera& camera, ManualClock& clock);
  FaultReport Play();

 private:
  // As a driver that waits in the kernel; one whose device is pulled is never woken.
  class WaitingCamera final : public ports::Camera {
   public:
    WaitingCamera(FaultPlay& play, std::unique_ptr<ports::Camera> camera)
        : play_(play), camera_(std::move(camera)) {}
    int pollable() const override { return camera_->pollable(); }
    Result<ports::CameraFrame> Next() override {
      auto frame = camera_->Next();
      while (!frame && frame.error().cause != std::errc::bad_message && !play_.is_over()) {
        play_.Pass();
        frame = camera_->Next();
      }
      return frame;
    }

   private:
    FaultPlay& play_;
    std::unique_ptr<ports::Camera> camera_;
  };

  ports::CameraOpener Opener();
  bool is_over() const { return report_.faults >= evening_.faults && !fault_ && clock_.now() >= turn_at_; }
  void Pass();
  void TurnTheScript(Time now);
  void Begin(Time now);
  void Judge(Time now);
  void JudgeFault(Time now, float open);
  void Worst(double& worst, std::string& by, Duration took) const;

  Evening evening_;
  SpoiltCamera& camera_;
  ManualClock& clock_;
  std::mt19937 random_;
  board::BoardFile file_;
  board::Board board_;
  std::optional<LipReader> reader_;
  StageMouth mouth_;
  FaultReport report_;
  std::vector<Fault> bag_;      // Every kind once, before any comes again.
  std::optional<Fault> fault_;  // That lasts.
  Fault latest_ = Fault::kStall;
  Time turn_at_{}, began_{}, ended_{}, stage_at_{}, tick_at_{};
  float lips_open_ = 0;
  bool to_voice_ = true, to_rest_ = true;  // Done, since the fault began.
  bool spoke_ = false;
};

FaultPlay::FaultPlay(const Evening& evening, SpoiltCamera& camera, ManualClock& clock)
    : evening_(evening), camera_(camera), clock_(clock), random_(evening.seed), board_(file_.Open()) {
  reader_.emplace(Opener(), board_, board_.AcquireWriter<board::Lips>().value(), LipSettings{}, clock_);
  turn_at_ = clock_.now() + 2 * kQuiet;
  stage_at_ = clock_.now();
}

ports::CameraOpener FaultPlay::Opener() {
  return [this]() -> Result<std::unique_ptr<ports::Camera>> {
    auto camera = camera_.Open();
    if (!camera || !evening_.waits_for_ever) return camera;
    return std::make_unique<WaitingCamera>(*this, std::move(*camera));
  };
}

FaultReport FaultPlay::Play() {
  while (!is_over()) {
    Pass();
    if (!spoke_ && clock_.now() < tick_at_) continue;
    tick_at_ = clock_.now() + kTick;
    reader_->Step();
  }
  return report_;
}

// Time for everything but kaori-lips.
void FaultPlay::Pass() {
  clock_.Advance(kStep);
  const Time now = clock_.now();
  if (now >= turn_at_) TurnTheScript(now);
  spoke_ = camera_.Tick();
  if (now < stage_at_) return;
  stage_at_ += kStageFrame;
  Judge(now);
}

void FaultPlay::TurnTheScript(Time now) {
  if (!fault_) return Begin(now);
  camera_.End();
  if (TakesTheLips(*fault_) && !to_voice_) Worst(report_.to_voice_ms, report_.to_voice_by, now - began_);
  if (TakesTheLips(*fault_) && !to_rest_) Worst(report_.to_rest_ms, report_.to_rest_by, now - began_);
  fault_.reset();
  ended_ = now;
  turn_at_ = now + kQuiet + milliseconds(random_() % 500);
}

void FaultPlay::Begin(Time now) {
  if (report_.faults >= evening_.faults) return;
  if (bag_.empty()) {
    bag_.assign(camera_.faults().begin(), camera_.faults().end());
    std::ranges::shuffle(bag_, random_);
  }
  fault_ = latest_ = bag_.back();
  bag_.pop_back();
  ++report_.faults;
  to_voice_ = to_rest_ = false;
  began_ = now;
  const auto span_ms = static_cast<std::uint32_t>((kLongest - kShortest) / milliseconds(1));
  turn_at_ = now + kShortest + milliseconds(random_() % span_ms);
  camera_.Begin(*fault_, static_cast<std::uint32_t>(random_()));
}

void FaultPlay::Judge(Time now) {
  const board::Snapshot board = ReadAll(board_);
  const float open = mouth_.Move(board, now);
  if (report_.faults == 0) lips_open_ = open;
  const bool lips = board.lips.source == board::SourceState::kLive && board.lips.value.quality >= 0.3F;
  if (fault_ && !lips && !to_rest_) {
    to_rest_ = true;
    if (TakesTheLips(*fault_)) Worst(report_.to_rest_ms, report_.to_rest_by, now - began_);
  }
  if (report_.faults > 0) JudgeFault(now, open);
}

void FaultPlay::JudgeFault(Time now, float open) {
  const float strayed = std::abs(open - lips_open_) / lips_open_;
  if (fault_ && TakesTheLips(*fault_)) {
    if (strayed <= kNear || to_voice_) return;
    to_voice_ = true;
    Worst(report_.to_voice_ms, report_.to_voice_by, now - began_);
  } else if (!TakesTheLips(latest_)) {
    if (strayed <= report_.strayed) return;
    report_.strayed = strayed;
    report_.strayed_by = NameOf(latest_);
  } else if (strayed > kNear) {
    Worst(report_.back_ms, report_.back_by, now - ended_);
  }
}

void FaultPlay::Worst(double& worst, std::string& by, Duration took) const {
  if (Milliseconds(took) <= worst) return;
  worst = Milliseconds(took);
  by = fmt::format("{}, fault {}", NameOf(latest_), report_.faults);
}

}  // namespace

const char* NameOf(Fault fault) {
  switch (fault) {
    case Fault::kStall:
      return "a stall";
    case Fault::kGone:
      return "gone";
    case Fault::kIoError:
      return "an input/output error";
    case Fault::kBusy:
      return "busy";
    case Fault::kTorn:
      return "torn frames";
    case Fault::kGarbage:
      return "garbage";
    case Fault::kCovered:
      return "a covered lens";
    case Fault::kDrops:
      return "drops";
    case Fault::kNewFormat:
      return "a new format";
    case Fault::kTimeJump:
      return "a time jump";
  }
  return "unknown";
}

bool TakesTheLips(Fault fault) {
  return fault != Fault::kIoError && fault != Fault::kDrops && fault != Fault::kNewFormat &&
         fault != Fault::kTimeJump;
}

FaultReport Spend(const Evening& evening, SpoiltCamera& camera, ManualClock& clock) {
  return FaultPlay(evening, camera, clock).Play();
}

}  // namespace kaori::lips
