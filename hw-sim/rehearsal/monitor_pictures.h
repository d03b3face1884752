// The operators' monitor of a rehearsal as pictures in a folder.
#pragma once

#include <cstdint>
#include <ctime>
#include <span>
#include <string>

#include "drivers/base/options.h"
#include "drivers/base/result.h"
#include "drivers/ports/side_display.h"
#include "render/image/png.h"

namespace kaori::sim {

// 19:30 of a day in local time, at which a rehearsal begins: the same pictures on every machine.
std::time_t EveningBegins();

// A display that keeps what it is shown. One thread.
class PictureDisplay final : public ports::SideDisplay {
 public:
  explicit PictureDisplay(Size size) : picture_(image::Picture::Blank(size.width_px, size.height_px)) {}

  int width_px() const override { return picture_.width_px; }
  int height_px() const override { return picture_.height_px; }
  bool fresh() const override { return shows_ == 0; }
  // Errors: invalid_argument (a picture of another size).
  Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const ports::DisplayArea> areas) override;

  // As a screen would show it: what no area covered is not there.
  const image::Picture& picture() const { return picture_; }

 private:
  image::Picture picture_;
  int shows_ = 0;
};

// Writes a PNG once a second, named by the second of the show. One thread; blocks for the disk.
class MonitorPictures {
 public:
  // Makes the folder. Errors: those of the folder.
  static Result<MonitorPictures> Open(const std::string& folder, Size size, int hz);

  ports::SideDisplay& display() { return display_; }
  // To be called after each picture of the show. Errors: those of the disk.
  Result<void> Write();

 private:
  MonitorPictures(const std::string& folder, Size size, int hz) : display_(size), folder_(folder), hz_(hz) {}

  PictureDisplay display_;
  std::string folder_;
  int hz_;
  int pictures_ = 0;
};

}  // namespace kaori::sim
