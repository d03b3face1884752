// Changes the lips' settings while they are in use, by commands of a desk and by keys at the box. A command
// or a key becomes a change of the Calibration; a change is applied to the lips at once, and is on the disk
// only when it is saved.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>

#include "appliance/programs/lips/calibration.h"
#include "appliance/programs/lips/generations.h"
#include "appliance/programs/lips/lip_meter.h"
#include "appliance/programs/lips/protocol/protocol.h"
#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// What the tuning does to the lips; both are called on the lips' thread.
struct TuningActions {
  std::function<void(const LipSettings&)> apply;  // Uses settings from the next frame on.
  std::function<void(bool free)> free_exposure;   // Frees the camera's exposure, or holds it.
};

// Used by the lips' thread. Files are written by another thread, so that no frame waits for a disk. Desk and
// guide both act through it, so that every change has one history.
class Tuning {
 public:
  // Reads the generations of `file`, and blocks for the disk. With an empty path saving fails with a
  // complaint.
  Tuning(const LipSettings& now, std::filesystem::path file, TuningActions actions);
  // Waits for a file that is being written.
  ~Tuning();
  Tuning(const Tuning&) = delete;
  Tuning& operator=(const Tuning&) = delete;

  // Executes a command; report() then tells whether it succeeded, or why not. A command that needs a picture
  // is executed with the next one, and fails after a second without one. A later command that needs a picture
  // takes the place of one that still waits, which is answered with a complaint.
  void Execute(const Command& command, Time now);

  // Handles a measured picture. The planes are borrowed for the call. It may replace the reader's meter by
  // way of TuningActions::apply, so that the caller uses `meter` no more.
  void HandlePicture(const decode::Planes& planes, const LipMeter& meter, Time at, Time now);

  // Handles the end of a write, a file that another program changed, and commands whose picture did not come.
  void Step(Time now);

  // Undoes all changes but the first `changes`: see Report::changes.
  void RevertTo(std::size_t changes);

  const Report& report() const { return report_; }
  const LipSettings& settings() const { return used_; }  // The settings in use.
  // A file is being written.
  bool saving() const { return saving_.valid(); }

 private:
  struct Waiting {
    Command command;
    Time until;
  };
  // Executes a command that needs no picture, and gives why it failed; so do the three after it.
  std::string ExecuteNow(const Command& command);
  std::string Begin(const std::string& name);
  std::string SwitchTo(const std::optional<LipSettings>& settings, std::uint32_t gesture = 0);
  std::string Save();
  // Executes the command that waited for a picture.
  void SamplePaint(const decode::Planes& planes);
  // Puts a command's outcome into the report.
  void Answer(const Command& command, std::string complaint);
  // Brings the lips up to the calibration's settings.
  void Apply();
  // Takes up a settings file that somebody else has replaced.
  void CheckFile(Time now);
  // Brings the report up to date.
  void Refresh();

  Calibration calibration_;
  std::filesystem::path file_;
  TuningActions actions_;
  // The settings that the lips use, and those that the file has in its two generations.
  LipSettings used_;
  SavedSettings saved_;
  std::optional<Waiting> waiting_;
  Report report_;
  // The write that is under way, with what it writes and the command that asked for it.
  std::future<Result<void>> saving_;
  LipSettings being_saved_;
  std::uint32_t save_number_ = 0;
  // The file's time of change when it was last read.
  std::filesystem::file_time_type file_at_{};
  Time check_file_at_{};
};

}  // namespace kaori::lips
