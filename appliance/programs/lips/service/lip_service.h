// Everything by which people set the lips on site: a desk, keys and lamps, and a settings file that changes.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/lip_reader.h"
#include "appliance/programs/lips/service/desk_connection.h"
#include "appliance/programs/lips/service/guide.h"
#include "appliance/programs/lips/service/monitor_picture.h"
#include "appliance/programs/lips/service/tuning.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

struct LipServiceOptions {
  // A desk may connect, and the guide may show captions on the screen, also while the key switch is off.
  bool service = false;
  // Where settings are saved; empty: nowhere.
  std::filesystem::path file{};
  // The settings in use.
  LipSettings now{};
};

// Used by one thread. Borrows reader, board and clock, which outlive it. It lies on the heap, since the
// reader calls back into it.
class LipService {
 public:
  // Errors: those of the desk's socket, and
  //   device_or_resource_busy  another program calibrates on this board
  // Reads the settings' generations, and so blocks for the disk once.
  static Result<std::unique_ptr<LipService>> Open(const LipServiceOptions& options, LipReader& reader,
                                                  const board::Board& board, const Clock& clock);

  // The reader must still be there: it is told to call back no more.
  ~LipService();
  LipService(const LipService&) = delete;
  LipService& operator=(const LipService&) = delete;

  // Handles commands of the desk and keys, and sends reports. It never blocks. Call it every 50 ms or sooner.
  void Step();

  // For the main loop, which hands the voice's settings on, and for tests.
  const Tuning& tuning() const { return tuning_; }
  const Guide& guide() const { return guide_; }

 private:
  LipService(const LipServiceOptions& options, LipReader& reader, const board::Board& board,
             board::Writer<board::LipsGuide> writer, const Clock& clock);
  // Writes the section lips_guide while a calibration is under way, and once when it ends.
  void ShowGuide(Time now);
  bool ServiceSwitched() const;
  // Opens the desk's socket when the key is turned on, and closes it when it is turned back.
  void FollowKey();

  bool service_;
  LipReader& reader_;
  const board::Board& board_;
  board::Writer<board::LipsGuide> writer_;
  const Clock& clock_;
  Tuning tuning_;
  Guide guide_;
  std::optional<DeskConnection> connection_;
  bool key_was_on_ = false;
  MonitorPicture monitor_picture_;
  // The section says that a calibration is under way.
  bool shown_ = false;
};

}  // namespace kaori::lips
