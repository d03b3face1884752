// What can be done to the lips' settings while they are in use: by a desk, and by keys at the box.
#pragma once

#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>

#include "appliance/programs/lips/calibration.h"
#include "appliance/programs/lips/lip_meter.h"
#include "appliance/programs/lips/generations.h"
#include "appliance/programs/lips/service/words.h"
#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// What the tuning acts on.
struct TuningHands {
  std::function<void(const LipSettings&)> use;  // From the next frame on.
  std::function<void(bool free)> light;         // Frees the camera's exposure, or holds it.
};

// One thread, that of the lips; files are written on another one, so that no frame waits for a disk.
class Tuning {
 public:
  // Without a file nothing can be kept, and says so. Reads the generations; blocks for the disk.
  Tuning(const LipSettings& now, std::filesystem::path file, TuningHands hands);
  // Waits for a file that is being written.
  ~Tuning();
  Tuning(const Tuning&) = delete;
  Tuning& operator=(const Tuning&) = delete;

  // Does it, or notes why not; both are in report(). What needs a picture is done with the next one, and
  // fails after a second without.
  void Do(const Command& command, Time now);

  // Each measured picture, while the planes can be looked at.
  void See(const decode::Planes& planes, const LipMeter& meter, Time at, Time now);

  // News of the disk, a file that somebody else changed, and pictures that did not come.
  void Step(Time now);

  // Everything since `changes` is taken back: see Report::changes.
  void TakeBackTo(std::size_t changes);

  const Report& report() const { return report_; }
  const LipSettings& settings() const { return used_; }  // In use.
  bool saving() const { return saving_.valid(); }

 private:
  struct Waiting {
    Command command;
    Time until;
  };
  std::string DoNow(const Command& command);
  std::string Begin(const std::string& name);
  std::string GoTo(const std::optional<LipSettings>& settings, std::uint32_t gesture = 0);
  std::string Save();
  void Paint(const decode::Planes& planes);
  void Answer(const Command& command, std::string complaint);
  void Look(const LipMeter& meter, const decode::Planes& planes);
  void Apply();
  void LookAtFile(Time now);
  void Refresh();

  Calibration calibration_;
  std::filesystem::path file_;
  TuningHands hands_;
  LipSettings used_;
  Kept kept_;
  std::optional<Waiting> waiting_;
  Report report_;
  std::future<Result<void>> saving_;
  LipSettings being_saved_;
  std::uint32_t save_number_ = 0;
  std::filesystem::file_time_type file_at_{};
  Time look_at_{};
};

}  // namespace kaori::lips
