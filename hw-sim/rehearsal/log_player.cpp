#include "hw-sim/rehearsal/log_player.h"

#include <fmt/format.h>

#include "appliance/core/showlog/replay.h"
#include "appliance/programs/report/logged_show.h"
#include "appliance/programs/stage/quality_choice.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/log.h"

namespace kaori::sim {
namespace {

// A longer stretch without a frame is not filled with pictures: the log has a gap, or the screen was away.
constexpr Duration kLongestStill = std::chrono::seconds(1);

// Draws frames into memory and hands them on at the rate of the film.
class Drawing {
 public:
  Drawing(std::unique_ptr<stage::Studio> studio, Outputs outputs, const OutputOptions& options)
      : studio_(std::move(studio)),
        outputs_(std::move(outputs)),
        size_(options.size),
        step_(FromSeconds(1.0 / options.hz)),
        pixels_(static_cast<std::size_t>(size_.width_px) * static_cast<std::size_t>(size_.height_px) * 4) {}

  Result<void> Add(const scene::Scene& scene, Time at) {
    if (next_ == Time{} || at - next_ > kLongestStill) next_ = at;
    if (at < next_) return {};
    if (auto drawn = studio_->Draw(scene, {size_.width_px, size_.height_px, ports::PixelMemory{pixels_}});
        !drawn)
      return drawn;
    for (; next_ <= at; next_ += step_)
      if (auto ok = outputs_.Write({0, at, size_.width_px, size_.height_px, pixels_}, {}); !ok) return ok;
    return {};
  }

  Result<void> Finish() { return outputs_.Finish(); }

 private:
  std::unique_ptr<stage::Studio> studio_;
  Outputs outputs_;
  Size size_;
  Duration step_;
  std::vector<std::uint8_t> pixels_;
  Time next_{};  // When the next picture is due.
};

// Null where nobody wants pictures: then no graphics are needed either.
Result<std::unique_ptr<Drawing>> OpenDrawing(const LogPlayOptions& options, const show::Show& show) {
  if (options.output.film.empty() && options.output.pictures.empty()) return nullptr;
  auto outputs = Outputs::Open(options.output);
  if (!outputs) return tl::unexpected(outputs.error());
  auto studio = stage::Studio::Open(show);
  if (!studio) return tl::unexpected(studio.error());
  Log("drawing with {}: {}", (*studio)->renderer(), stage::ChooseQuality(**studio, options.quality));
  return std::make_unique<Drawing>(std::move(*studio), std::move(*outputs), options.output);
}

// Plays from the beginning of the chunk in which `from` lies; frames before it are made, for the state goes
// through them, and not drawn.
Result<LogPlayed> PlayThrough(const showlog::LogFile& log, const show::Show& show, Time from,
                              const LogPlayOptions& options, Drawing* drawing) {
  const Time until = options.length_s > 0 ? from + FromSeconds(options.length_s) : Time::max();
  showlog::Replay replay(log, show);
  replay.GoTo(from);
  LogPlayed played;
  Time last{};
  while (replay.Next() && replay.presented_at() < until) {
    if (replay.presented_at() < from) continue;
    last = replay.presented_at();
    if (played.from.empty()) played.from = log.DayTimeText(last);
    if (drawing != nullptr)
      if (auto ok = drawing->Add(replay.made().scene, last); !ok) return tl::unexpected(ok.error());
  }
  for (const std::string& fault : replay.faults()) LogWarning("{}: {}", options.log, fault);
  if (played.from.empty())
    return FailInput(fmt::format("{}: it has nothing at that time; it begins at {}", options.log,
                                 log.DayTimeText(log.chunks().front().head.first)));
  played.until = log.DayTimeText(last);
  played.frames = replay.frames();
  played.differ = replay.frames_that_differ();
  if (const auto first = replay.first_difference()) played.first_difference = log.DayTimeText(*first);
  return played;
}

}  // namespace

// All that can be wrong with the options is found before a film is begun. What is spoilt in the log is said,
// and what is whole is played.
Result<LogPlayed> PlayLog(const LogPlayOptions& options) {
  const auto log = showlog::LogFile::Read(options.log);
  if (!log) return tl::unexpected(log.error());
  for (const std::string& fault : log->faults()) LogWarning("{}", fault);
  auto show = report::LoadShowOfLog(options.pack, log->head(), options.own);
  if (!show) return tl::unexpected(show.error());
  const Time begin = log->chunks().front().head.first;
  const auto from = options.at.empty() ? std::optional(begin) : log->AtDayTime(options.at);
  if (!from) return FailInput(fmt::format("--at {}: a time of day is expected, as in 19:43:10", options.at));
  auto drawing = OpenDrawing(options, *show);
  if (!drawing) return tl::unexpected(drawing.error());
  auto played = PlayThrough(*log, *show, *from, options, drawing->get());
  if (!played || !*drawing) return played;
  if (auto ok = (*drawing)->Finish(); !ok) return tl::unexpected(ok.error());
  return played;
}

}  // namespace kaori::sim
