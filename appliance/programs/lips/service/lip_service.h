// Everything by which people set the lips on site: a desk, keys and lamps, and a file that changes.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/lip_reader.h"
#include "appliance/programs/lips/service/guide.h"
#include "appliance/programs/lips/service/outlet.h"
#include "appliance/programs/lips/service/tuning.h"
#include "drivers/base/clock.h"

namespace kaori::lips {

struct LipServiceOptions {
  bool service =
      false;  // A desk may ask, and the guide may speak on the screen, as it may with the key switch.
  std::filesystem::path file{};  // Where settings are kept; empty: nowhere.
  LipSettings now{};             // In use.
};

// One thread. Borrows reader, board and clock for its life.
class LipService {
 public:
  // Errors: those of the desk's socket; device_or_resource_busy (another one calibrates on this board).
  static Result<std::unique_ptr<LipService>> Open(const LipServiceOptions& options, LipReader& reader,
                                                  const board::Board& board, const Clock& clock);

  ~LipService();
  LipService(const LipService&) = delete;
  LipService& operator=(const LipService&) = delete;

  // Hears the desk and the keys, and speaks. Call it every 50 ms or sooner; never blocks.
  void Step();

  const Tuning& tuning() const { return tuning_; }
  const Guide& guide() const { return guide_; }

 private:
  LipService(const LipServiceOptions& options, LipReader& reader, const board::Board& board,
             board::Writer<board::LipsGuide> writer, const Clock& clock);
  void ShowGuide(Time now);
  bool ServiceSwitched() const;

  bool service_;
  LipReader& reader_;
  const board::Board& board_;
  board::Writer<board::LipsGuide> writer_;
  const Clock& clock_;
  Tuning tuning_;
  Guide guide_;
  std::optional<Outlet> outlet_;
  bool shown_ = false;
};

}  // namespace kaori::lips
