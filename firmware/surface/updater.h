// Takes a new image over the wire and puts it into the slot that does not run.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/surface/flash.h"
#include "firmware/surface/slots.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::surface {

// What runs now.
struct Running {
  Slot slot = Slot::kA;
  std::uint32_t product = 0;         // Vendor id * 65536 + product id.
  std::uint32_t oldest_version = 0;  // Older images are refused: major * 65536 + minor.
};

// Begin, Data in order, End. What comes out of order, or is for another device, is refused and changes
// nothing in flash. The slot that runs is never written but for Keep. One side; a call takes as long as the
// flash needs, up to 0.4 s.
class Updater {
 public:
  // Borrows the flash.
  Updater(Flash& flash, const Running& running) : flash_(flash), running_(running) {}

  // False: refused. An image that nobody has confirmed may not erase the one that was.
  bool Begin(const wire::SurfaceImage& image);
  bool Data(std::uint32_t offset, std::span<const std::uint8_t> bytes);
  // Writes the header where the image has its hash.
  bool End();
  // The image that runs is good.
  void Keep() { surface::Keep(flash_, running_.slot); }

  wire::SurfaceState state() const;
  std::uint32_t bytes_taken() const { return taken_; }

 private:
  enum class Step : std::uint8_t { kIdle, kTaking, kWhole };
  // Writes the page that is gathered, and reads it back.
  bool WritePage();
  std::uint32_t NextGeneration() const;

  Flash& flash_;
  const Running running_;
  Step step_ = Step::kIdle;
  wire::SurfaceImage image_;
  std::uint32_t taken_ = 0;                      // Bytes of the image that came.
  std::array<std::uint8_t, kPageBytes> page_{};  // The last of them that fill no page yet.
};

}  // namespace kaori::surface
