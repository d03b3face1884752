#include "appliance/programs/lips/service/tuning.h"

#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include "appliance/programs/lips/service/paint_finder.h"
#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

constexpr Duration kPictureComes = std::chrono::seconds(1);
constexpr Duration kFilePeriod = std::chrono::seconds(1);
constexpr int kReachFound = 2;  // Round a place that is known to be the paint's; lips may be thin.

std::filesystem::file_time_type TimeOf(const std::filesystem::path& file) {
  std::error_code none;
  const auto at = std::filesystem::last_write_time(file, none);
  return none ? std::filesystem::file_time_type{} : at;
}

std::string ComplaintOf(const Result<void>& done) {
  return done ? std::string() : done.error().message();
}

std::array<float, 4> BoxOf(const LipMeter& meter, const decode::Planes& planes) {
  const auto& sight = meter.sight();
  if (!sight || planes.y.width_px <= 0 || planes.y.height_px <= 0) return {};
  const auto width = static_cast<float>(planes.y.width_px);
  const auto height = static_cast<float>(planes.y.height_px);
  const Shape& shape = sight->shape;
  return {(shape.middle.x - shape.width_px / 2) / width, (shape.middle.y - shape.height_px / 2) / height,
          (shape.middle.x + shape.width_px / 2) / width, (shape.middle.y + shape.height_px / 2) / height};
}

}  // namespace

Tuning::Tuning(const LipSettings& now, std::filesystem::path file, TuningHands hands)
    : calibration_(now), file_(std::move(file)), hands_(std::move(hands)), used_(now) {
  if (!file_.empty()) {
    kept_ = ReadGenerations(file_);
    file_at_ = TimeOf(file_);
  }
  Refresh();
}

Tuning::~Tuning() {
  if (saving_.valid()) saving_.wait();
}

void Tuning::Do(const Command& command, Time now) {
  if (command.ask == Ask::kSample || command.ask == Ask::kFind) {
    if (waiting_) Answer(waiting_->command, "another one came before it was done");
    waiting_ = Waiting{command, now + kPictureComes};
    return;
  }
  if (command.ask == Ask::kSave) save_number_ = command.number;
  std::string complaint = DoNow(command);
  if (command.ask != Ask::kSave || !complaint.empty()) Answer(command, std::move(complaint));
  Apply();
}

std::string Tuning::DoNow(const Command& command) {
  switch (command.ask) {
    case Ask::kSet: {
      const auto changed = WithValue(calibration_.settings(), command.name, command.a);
      return changed ? GoTo(*changed, static_cast<std::uint32_t>(std::abs(command.b)))
                     : changed.error().message();
    }
    case Ask::kBegin:
      return Begin(command.name);
    case Ask::kStop:
      calibration_.GiveUp();
      return {};
    case Ask::kUndo:
      return calibration_.Revert() ? std::string() : "there is nothing to take back";
    case Ask::kSaved:
      return GoTo(kept_.now);
    case Ask::kBefore:
      return GoTo(kept_.before);
    case Ask::kDefaults:
      return GoTo(LipSettings{});
    case Ask::kSave:
      return Save();
    case Ask::kLight:
      report_.free_light = command.a > 0;
      hands_.light(report_.free_light);
      return {};
    default:
      return {};
  }
}

std::string Tuning::Begin(const std::string& name) {
  for (int step = 0; step < kStepCount; ++step)
    if (NameOf(static_cast<CalibrationStep>(step)) == name) {
      calibration_.Begin(static_cast<CalibrationStep>(step));
      return {};
    }
  return "there is no step " + name;
}

std::string Tuning::GoTo(const std::optional<LipSettings>& settings, std::uint32_t gesture) {
  if (!settings) return "nothing was kept";
  calibration_.Set(*settings, gesture);
  return {};
}

std::string Tuning::Save() {
  if (file_.empty()) return "there is no file to keep it in";
  if (saving_.valid()) return "it is being saved";
  being_saved_ = calibration_.settings();
  saving_ = std::async(std::launch::async, WriteGeneration, file_, being_saved_);
  return {};
}

void Tuning::See(const decode::Planes& planes, const LipMeter& meter, Time at, Time now) {
  if (waiting_) Paint(planes);
  const auto step = calibration_.step();
  if (calibration_.Feed(meter.lips(), at)) {
    report_.taken |= 1U << static_cast<unsigned>(*step);
    report_.complaint.clear();
  }
  report_.box = BoxOf(meter, planes);
  Apply();
  Step(now);
}

void Tuning::Paint(const decode::Planes& planes) {
  const Waiting waiting = *std::exchange(waiting_, std::nullopt);
  if (waiting.command.ask == Ask::kFind) {
    const auto found = FindPaint(planes);
    if (!found) return Answer(waiting.command, "no paint is seen");
    return Answer(waiting.command,
                  ComplaintOf(calibration_.SamplePaint(planes, found->x, found->y, kReachFound)));
  }
  const Command& click = waiting.command;
  Answer(click, ComplaintOf(calibration_.SamplePaint(planes, click.a, click.b)));
}

void Tuning::Answer(const Command& command, std::string complaint) {
  report_.answered = command.number;
  report_.complaint = std::move(complaint);
}

void Tuning::TakeBackTo(std::size_t changes) {
  calibration_.GiveUp();
  calibration_.RevertTo(changes);
  Apply();
}

void Tuning::Apply() {
  if (calibration_.settings() != used_) {
    used_ = calibration_.settings();
    hands_.use(used_);
  }
  Refresh();
}

void Tuning::Step(Time now) {
  if (waiting_ && now >= waiting_->until)
    Answer(std::exchange(waiting_, std::nullopt)->command, "no picture comes from the camera");
  if (saving_.valid() && saving_.wait_for(Duration{}) == std::future_status::ready) {
    const Result<void> saved = saving_.get();
    report_.answered = save_number_;
    report_.complaint = ComplaintOf(saved);
    kept_ = ReadGenerations(file_);
    file_at_ = TimeOf(file_);
    Log("lips: {}", saved ? "the calibration is saved" : report_.complaint);
  }
  LookAtFile(now);
  Refresh();
}

// Who puts another file there, or changes it, need not start the lips again.
void Tuning::LookAtFile(Time now) {
  if (file_.empty() || saving_.valid() || now < look_at_) return;
  look_at_ = now + kFilePeriod;
  const auto at = TimeOf(file_);
  if (at == file_at_) return;
  file_at_ = at;
  kept_ = ReadGenerations(file_);
  if (!kept_.complaint.empty()) LogWarning("{}; playing on as before", kept_.complaint);
  if (!kept_.now || *kept_.now == calibration_.settings()) return;
  Log("lips: {} was changed, and is taken", file_.string());
  calibration_.Set(*kept_.now);
  Apply();
}

void Tuning::Refresh() {
  report_.step = calibration_.step();
  report_.progress = calibration_.progress();
  report_.changes = static_cast<std::uint32_t>(calibration_.changes());
  report_.saved = kept_.now.has_value();
  report_.before = kept_.before.has_value();
  report_.unsaved = calibration_.settings() != kept_.now.value_or(LipSettings{});
  for (std::size_t n = 0; n < kSettingCount; ++n) report_.values[n] = ValueOf(calibration_.settings(), n);
}

}  // namespace kaori::lips
