#include "appliance/programs/stage/stage_status_display.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/lines.h"
#include "appliance/programs/status/screens_file.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;

constexpr Duration kFactsPeriod = 1s;  // How often files are looked at.
constexpr int kShare = 16;             // Of a frame's usual time, for lines that changed.
constexpr Duration kGivenUp = 60s;     // How long a display that cannot show is left alone.
constexpr auto kDiskPause = 1s;        // Before a file that could not be written is tried again.

}  // namespace

// The file of screens is written on the writer's thread, from a copy that is taken under the lock: the
// stage's thread never waits for a disk.
StageStatusDisplay::StageStatusDisplay(const board::Board& board, const Clock& clock, status::Places places)
    : board_(board), clock_(clock), places_(std::move(places)), writer_(kDiskPause, [this] {
        std::unique_lock lock(text_mutex_);
        const std::string text = screens_text_;
        lock.unlock();
        return WriteWholeFile(places_.screens, {AsBytes(text)}).has_value();
      }) {}

// A display that is busy with the last rows is no failure: what it was not shown is owed and comes at the
// next step.
void StageStatusDisplay::Step(ports::Scanout* screen) {
  LookAtScreens(screen);
  ports::SideDisplay* const display = DisplayOf(screen);
  LookAtFacts();
  notice_ = display == nullptr ? facts_.shows : std::vector<std::string>();
  if (display == nullptr) sheet_.reset();  // Somebody else may draw there before it is back.
  if (display == nullptr || clock_.now() < silent_until_) return;
  const auto shown = ShowNext(*display);
  owed_ = !shown && shown.error().cause == std::errc::device_or_resource_busy;
  if (shown || owed_) return;
  LogWarning("the status cannot be shown ({})", shown.error().message());
  silent_until_ = clock_.now() + kGivenUp;
}

ports::SideDisplay* StageStatusDisplay::DisplayOf(ports::Scanout* screen) {
  on_monitor_ = false;
  if (screen == nullptr) return nullptr;
  if (auto* display = screen->status_display(); display != nullptr) return display;
  on_monitor_ = screen->monitor_display() != nullptr && board::IsServiceKeyOn(board_.Read<board::Lines>());
  return on_monitor_ ? screen->monitor_display() : nullptr;
}

// The facts hold the screens too, so that they are read anew when those change.
void StageStatusDisplay::LookAtScreens(ports::Scanout* screen) {
  auto outputs = screen == nullptr ? std::vector<ports::Output>() : screen->outputs();
  if (screens_ == outputs) return;
  {
    const std::scoped_lock lock(text_mutex_);
    screens_text_ = status::FormatScreens(outputs);
  }
  writer_.Ask();
  screens_ = std::move(outputs);
  facts_read_ = {};
}

// Files are looked at once a second, or when the screens have changed; the board is memory and read at each
// step.
void StageStatusDisplay::LookAtFacts() {
  const Time now = clock_.now();
  if (facts_read_ != Time{} && now - facts_read_ < kFactsPeriod) return;
  facts_ = status::ReadFacts(places_);
  facts_read_ = now;
}

std::vector<status::Line> StageStatusDisplay::Lines() const {
  return status::Describe(status::Look(board_, facts_, clock_.now()));
}

// A display that was plugged in, or changed its mode, is blank or of another size: everything is drawn anew.
Result<void> StageStatusDisplay::ShowNext(ports::SideDisplay& display) {
  const bool anew = display.fresh() || !sheet_;
  const auto rows = anew ? DrawAnew(display) : DrawChanged();
  if (!rows) return tl::unexpected(rows.error());
  if (rows->first == rows->end && !owed_) return {};
  const ports::DisplayArea area{0, rows->first, display.width_px(), rows->end};
  return display.Show(sheet_->picture().rgbx, {&area, 1});
}

// Its lines come one after the other.
Result<status::Sheet::Rows> StageStatusDisplay::DrawAnew(const ports::SideDisplay& display) {
  auto lettering = image::Lettering::Open();
  if (!lettering) return tl::unexpected(lettering.error());
  sheet_.emplace(std::move(*lettering), display.width_px(), display.height_px());
  return status::Sheet::Rows{0, display.height_px()};
}

// Rows of the lines that were drawn, as one range; {0, 0} where nothing changed.
status::Sheet::Rows StageStatusDisplay::DrawChanged() {
  const auto lines = Lines();
  const auto frame = board_.Read<board::StageStatus>().value.draw;
  const Time until = clock_.now() + frame / kShare;
  status::Sheet::Rows all{sheet_->picture().height_px, 0};
  while (const auto drawn = sheet_->DrawNext(lines)) {
    all = {std::min(all.first, drawn->first), std::max(all.end, drawn->end)};
    if (clock_.now() >= until) break;
  }
  return all.end == 0 ? status::Sheet::Rows{} : all;
}

}  // namespace kaori::stage
