// From a camera's picture to the mouth's sizes: key, regions, search, contour and gauge, one after the other.
//
// What happens to a picture, in this order:
//
//   key       paint_key.h      each sample of chroma: paint or not, by three half planes of the Cb/Cr plane
//   mask      paint_mask.h     one bit for each sample of a square grid, without single specks
//   regions   region.h         runs of paint, joined into connected regions
//   search    mouth_search.h   which regions are the mouth, by form, size and where the last mouth was
//   contour   contour.h        the edge of the paint, finer than a sample, and the gap between the lips
//   gauge     mouth_gauge.h    sizes in widths of the mouth at rest, wherever the head is, smoothed
//
// Luma takes no part in finding the paint: half a mouth in shadow is still a mouth.
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/contour.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/mouth_gauge.h"
#include "appliance/programs/lips/mouth_search.h"
#include "appliance/programs/lips/paint_key.h"
#include "appliance/programs/lips/paint_mask.h"
#include "appliance/programs/lips/region.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Used by one thread. It allocates nothing once it has measured a few pictures of a size.
class LipMeter {
 public:
  // Goes on from `before`: see MouthGauge.
  LipMeter(const LipSettings& settings, const board::Lips& before)
      : key_(settings.paint, settings.key), search_(settings.marker), gauge_(before, settings.gauge) {}

  // Measures the mouth in a picture that was exposed at `at`, and searches it first where the last one was.
  // The planes are borrowed for the call. Without a mouth the sizes stay and the quality is 0. `at` rises
  // from call to call.
  const board::Lips& Measure(const decode::Planes& planes, Time at);

  // The sizes as they are on the board, from the last picture with a mouth.
  const board::Lips& lips() const { return gauge_.lips(); }

  // These belong to the picture that was measured last.
  const PaintMask& mask() const { return mask_; }
  const PaintKey& key() const { return key_; }
  const std::optional<Detection>& detection() const { return detection_; }

 private:
  // Forgets the last position where the picture has another size.
  void NoteSize(const decode::Plane& picture);
  // Key, regions, search and contour; nothing where one of them finds no mouth.
  std::optional<Detection> Detect(const decode::Planes& planes, Time at);
  // Whether enough of a mouth's samples are paint beyond doubt.
  bool IsPaint(const decode::Planes& planes, const Region& mouth);

  PaintKey key_;
  // The stages of a picture, in their order; each keeps its buffers.
  PaintMask mask_;
  Regions regions_;
  MouthSearch search_;
  ContourReader contour_reader_;
  MouthGauge gauge_;
  std::optional<Detection> detection_;
  int width_px_ = 0;  // The size of the last picture.
  int height_px_ = 0;
};

}  // namespace kaori::lips
