#include "appliance/programs/lips/service/tuning.h"

#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include "appliance/programs/lips/service/paint_finder.h"
#include "drivers/base/log.h"

namespace kaori::lips {
namespace {

// A camera that works sends 15 pictures in this time at the least.
constexpr Duration kPictureTimeout = std::chrono::seconds(1);
// How often the settings file is looked at, in case another program has replaced it.
constexpr Duration kFilePeriod = std::chrono::seconds(1);
constexpr int kReachFound =
    2;  // A smaller reach around a point that is known to be paint, since lips may be thin.

// When the file was changed; the same "never" for one that is not there.
std::filesystem::file_time_type TimeOf(const std::filesystem::path& file) {
  std::error_code none;
  const auto at = std::filesystem::last_write_time(file, none);
  return none ? std::filesystem::file_time_type{} : at;
}

// As reports have it: empty where it succeeded.
std::string ComplaintOf(const Result<void>& done) {
  return done ? std::string() : done.error().message();
}

// The upright box around the mouth's sizes, in parts of the picture: a tilted mouth sticks out a little.
std::array<float, 4> BoxOf(const LipMeter& meter, const decode::Planes& planes) {
  const auto& detection = meter.detection();
  if (!detection || planes.y.width_px <= 0 || planes.y.height_px <= 0) return {};
  const auto width = static_cast<float>(planes.y.width_px);
  const auto height = static_cast<float>(planes.y.height_px);
  const Contour& contour = detection->contour;
  return {
      (contour.middle.x - contour.width_px / 2) / width, (contour.middle.y - contour.height_px / 2) / height,
      (contour.middle.x + contour.width_px / 2) / width, (contour.middle.y + contour.height_px / 2) / height};
}

}  // namespace

// The settings in use are the caller's. The file is read only for what can be gone back to, and for its time.
Tuning::Tuning(const LipSettings& now, std::filesystem::path file, TuningActions actions)
    : calibration_(now), file_(std::move(file)), actions_(std::move(actions)), used_(now) {
  if (!file_.empty()) {
    saved_ = ReadGenerations(file_);
    file_at_ = TimeOf(file_);
  }
  Refresh();
}

// A save that was asked for is waited for, even where the program ends right after it.
Tuning::~Tuning() {
  if (saving_.valid()) saving_.wait();
}

// A save is answered when the disk has it, and a sample when a picture came; all other commands are answered
// here.
void Tuning::Execute(const Command& command, Time now) {
  if (command.kind == CommandKind::kSample || command.kind == CommandKind::kFind) {
    if (waiting_) Answer(waiting_->command, "another command came before this one was done");
    waiting_ = Waiting{command, now + kPictureTimeout};
    return;
  }
  std::string complaint = ExecuteNow(command);
  if (command.kind == CommandKind::kSave && complaint.empty())
    save_number_ = command.number;
  else
    Answer(command, std::move(complaint));
  Apply();
}

// Gives the complaint; empty: it is done.
std::string Tuning::ExecuteNow(const Command& command) {
  switch (command.kind) {
    case CommandKind::kSet: {
      const auto changed = WithValue(calibration_.settings(), command.name, command.a);
      return changed ? SwitchTo(*changed, static_cast<std::uint32_t>(std::abs(command.b)))
                     : changed.error().message();
    }
    case CommandKind::kBegin:
      return Begin(command.name);
    case CommandKind::kStop:
      calibration_.Cancel();
      return {};
    case CommandKind::kUndo:
      return calibration_.Revert() ? std::string() : "there is no change to undo";
    case CommandKind::kSaved:
      return SwitchTo(saved_.now);
    case CommandKind::kBefore:
      return SwitchTo(saved_.before);
    case CommandKind::kDefaults:
      return SwitchTo(LipSettings{});
    case CommandKind::kSave:
      return Save();
    case CommandKind::kExposure:
      report_.exposure_free = command.a > 0;
      actions_.free_exposure(report_.exposure_free);
      return {};
    default:
      return {};
  }
}

std::string Tuning::Begin(const std::string& name) {
  const auto step = StepNamed(name);
  if (!step) return "there is no calibration step " + name;
  calibration_.Begin(*step);
  return {};
}

// Nothing stands for a generation that was never saved.
std::string Tuning::SwitchTo(const std::optional<LipSettings>& settings, std::uint32_t gesture) {
  if (!settings) return "no settings are saved";
  calibration_.Set(*settings, gesture);
  return {};
}

// On a thread of its own, with copies: the settings may change meanwhile.
std::string Tuning::Save() {
  if (file_.empty()) return "there is no file to save the settings in";
  if (saving_.valid()) return "the settings are being saved already";
  being_saved_ = calibration_.settings();
  saving_ = std::async(std::launch::async, WriteGeneration, file_, being_saved_);
  return {};
}

// A sample before a step: a colour that changes now is measured with from the next picture on.
void Tuning::HandlePicture(const decode::Planes& planes, const LipMeter& meter, Time at, Time now) {
  if (waiting_) SamplePaint(planes);
  const auto step = calibration_.step();
  if (calibration_.Feed(meter.lips(), at)) {
    report_.done |= 1U << static_cast<unsigned>(*step);
    report_.complaint.clear();
  }
  report_.box = BoxOf(meter, planes);
  Apply();
  Step(now);
}

// The command waited for this picture.
void Tuning::SamplePaint(const decode::Planes& planes) {
  const Waiting waiting = *std::exchange(waiting_, std::nullopt);
  if (waiting.command.kind == CommandKind::kFind) {
    const auto found = FindPaint(planes);
    if (!found) return Answer(waiting.command, "no paint was found in the picture");
    return Answer(waiting.command,
                  ComplaintOf(calibration_.SamplePaint(planes, found->x, found->y, kReachFound)));
  }
  const Command& click = waiting.command;
  Answer(click, ComplaintOf(calibration_.SamplePaint(planes, click.a, click.b)));
}

// The desk numbers its commands and may have sent others since: the number says which one is meant.
void Tuning::Answer(const Command& command, std::string complaint) {
  report_.answered = command.number;
  report_.complaint = std::move(complaint);
}

// A step that is under way would add a change after it, and is cancelled.
void Tuning::RevertTo(std::size_t changes) {
  calibration_.Cancel();
  calibration_.RevertTo(changes);
  Apply();
}

// Only a difference reaches the reader: using settings starts its search anew.
void Tuning::Apply() {
  if (calibration_.settings() != used_) {
    used_ = calibration_.settings();
    actions_.apply(used_);
  }
  Refresh();
}

// The thread that writes is asked without waiting. After a save both generations are read back, so that the
// report says what really lies there.
void Tuning::Step(Time now) {
  if (waiting_ && now >= waiting_->until)
    Answer(std::exchange(waiting_, std::nullopt)->command, "no picture comes from the camera");
  if (saving_.valid() && saving_.wait_for(Duration{}) == std::future_status::ready) {
    const Result<void> saved = saving_.get();
    report_.answered = save_number_;
    report_.complaint = ComplaintOf(saved);
    saved_ = ReadGenerations(file_);
    file_at_ = TimeOf(file_);
    saved ? Log("lips: the settings were saved") : LogWarning("lips: {}", report_.complaint);
  }
  CheckFile(now);
  Refresh();
}

// A file that a person or another program replaces is used without a restart of the lips. By its time of
// change, once a second. Its settings are one change, which can be undone.
void Tuning::CheckFile(Time now) {
  if (file_.empty() || saving_.valid() || now < check_file_at_) return;
  check_file_at_ = now + kFilePeriod;
  const auto at = TimeOf(file_);
  if (at == file_at_) return;
  file_at_ = at;
  saved_ = ReadGenerations(file_);
  if (!saved_.complaint.empty()) LogWarning("{}; the lips go on with the settings in use", saved_.complaint);
  if (!saved_.now || *saved_.now == calibration_.settings()) return;
  Log("lips: {} was changed by another program; its settings are in use now", file_.string());
  calibration_.Set(*saved_.now);
  Apply();
}

// Brings the parts of the report that follow from other state up to date.
void Tuning::Refresh() {
  report_.step = calibration_.step();
  report_.progress = calibration_.progress();
  report_.changes = static_cast<std::uint32_t>(calibration_.changes());
  report_.saved = saved_.now.has_value();
  report_.before = saved_.before.has_value();
  report_.unsaved = calibration_.settings() != saved_.now.value_or(LipSettings{});
  for (std::size_t n = 0; n < kSettingCount; ++n) report_.values[n] = ValueOf(calibration_.settings(), n);
}

}  // namespace kaori::lips
