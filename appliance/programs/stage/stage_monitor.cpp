#include "appliance/programs/stage/stage_monitor.h"

#include <algorithm>
#include <array>
#include <utility>

#include "appliance/programs/stage/local_time.h"
#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPicturePeriod = 60ms;  // With the steps' own period about 15 a second.
constexpr Duration kTextPeriod = 100ms;
constexpr Duration kLipsPeriod = 100ms;
constexpr Duration kOldestLips = 2s;         // A camera's picture that is older is none.
constexpr int kRest = 40;                    // Times as long as a portion took.
constexpr int kTextShare = 16;               // Of a frame's usual time, for a portion's text.
constexpr Duration kLeastTextShare = 500us;  // Whatever the frame takes.
constexpr Duration kRoom = 2ms;              // Before a frame begins no portion does,
constexpr int kMostLeftAlone = 4;            // but not more often than so in a row.
constexpr int kMostProgramme_px = 960;       // Of its width: a larger picture is not worth its copying.
constexpr Duration kMonitorGivenUp = 60s;

}  // namespace

std::string TimeOfDay(std::time_t now) {
  std::tm local{};
  if (WeekMinute(now) == performance::kNoWeekMinute || ::localtime_r(&now, &local) == nullptr) return {};
  std::array<char, 16> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%H:%M:%S", &local)};
}

StageMonitor::StageMonitor(const board::Board& board, const Clock& clock, Studio& studio,
                           const StageStatusDisplay& status, std::function<std::time_t()> time_of_day)
    : board_(board), clock_(clock), studio_(studio), status_(status), time_of_day_(std::move(time_of_day)) {}

// A display that is busy with the last areas is no failure: they are owed and come at the next step.
void StageMonitor::Step(ports::SideDisplay* display, const StageNow& stage) {
  if (display == nullptr) return Close();
  const Time began = clock_.now();
  if (began < next_step_ || began < silent_until_) return;
  const bool is_near = stage.next_frame && *stage.next_frame > began && *stage.next_frame - began < kRoom;
  if (is_near && left_alone_++ < kMostLeftAlone) return;
  left_alone_ = 0;
  if (!Open(*display)) return;
  DrawDue(stage);
  const auto shown = Show(*display);
  const Time now = clock_.now();
  next_step_ = now + std::max(kPicturePeriod, (now - began) * kRest);
  owed_ = !shown && shown.error().cause == std::errc::device_or_resource_busy;
  if (shown || owed_) return;
  LogWarning("the operators' monitor cannot be shown ({})", shown.error().message());
  silent_until_ = now + kMonitorGivenUp;
}

void StageMonitor::Close() {
  sheet_.reset();
  lips_.reset();
  areas_.clear();
  owed_ = false;
}

// A display that was plugged in, or changed its mode, is blank or of another size: everything is drawn anew.
bool StageMonitor::Open(const ports::SideDisplay& display) {
  if (sheet_ && !display.fresh()) return true;
  auto lettering = image::Lettering::Open();
  if (!lettering) {
    LogWarning("there is no operators' monitor ({})", lettering.error().message());
    silent_until_ = clock_.now() + kMonitorGivenUp;
    return false;
  }
  const bool is_new = !sheet_;
  sheet_.emplace(std::move(*lettering), display.width_px(), display.height_px());
  areas_ = {{0, 0, display.width_px(), display.height_px()}};
  next_text_ = next_lips_ = lips_shown_ = {};
  if (!is_new) return true;
  auto lips = board::LipPictureReader::Make(board::LipPicturePath(board_.path()));
  if (lips) lips_.emplace(std::move(*lips));
  if (!lips) LogWarning("the monitor has no picture of the lips ({})", lips.error().message());
  return true;
}

// Pictures first; then cells that changed, for a small part of a frame's usual time, and one at least.
void StageMonitor::DrawDue(const StageNow& stage) {
  const Time began = clock_.now();
  const auto frame = board_.Read<board::StageStatus>().value.draw;
  const Time until = began + std::max<Duration>(kLeastTextShare, frame / kTextShare);
  if (began >= next_text_) {
    next_text_ = began + kTextPeriod;
    const auto& picture = sheet_->picture();
    sheet_->Set(monitor::LayOut(ViewOf(stage.state), picture.width_px, picture.height_px));
  }
  DrawPictures();
  while (const auto drawn = sheet_->DrawNext()) {
    areas_.push_back(*drawn);
    if (clock_.now() >= until) break;
  }
}

// A copy of the face that was asked for at one step is there at the next one.
void StageMonitor::DrawPictures() {
  if (studio_.FetchPicture(programme_))
    areas_.push_back(sheet_->DrawProgramme({programme_.width_px, programme_.height_px, programme_.pixels}));
  const monitor::Box& place = sheet_->page().programme;
  studio_.AskPicture(std::min(place.width, kMostProgramme_px), place.height);
  const Time now = clock_.now();
  if (now < next_lips_) return;
  const bool is_first = next_lips_ == Time{};
  next_lips_ = now + kLipsPeriod;
  const auto seen = lips_ ? lips_->Read() : std::nullopt;
  const bool is_there = seen && now - seen->at < kOldestLips;
  if (is_there && seen->at != lips_shown_)
    areas_.push_back(sheet_->DrawLips({seen->width_px, seen->height_px, seen->pixels}));
  if (!is_there && (is_first || lips_shown_ != Time{})) areas_.push_back(sheet_->DrawLips({}));
  lips_shown_ = is_there ? seen->at : Time{};
}

Result<void> StageMonitor::Show(ports::SideDisplay& display) {
  if (areas_.empty() && !owed_) return {};
  auto shown = display.Show(sheet_->picture().rgbx, areas_);
  areas_.clear();
  return shown;
}

monitor::View StageMonitor::ViewOf(const performance::State& state) const {
  return monitor::Describe({.show = studio_.show(),
                            .state = state,
                            .show_now = board_.Read<board::ShowNow>(),
                            .lips = board_.Read<board::Lips>(),
                            .voice = board_.Read<board::Voice>(),
                            .stage_status = board_.Read<board::StageStatus>(),
                            .lines = board_.Read<board::Lines>(),
                            .status = status_.Lines(),
                            .time_of_day = TimeOfDay(time_of_day_()),
                            .now = clock_.now()});
}

}  // namespace kaori::stage
