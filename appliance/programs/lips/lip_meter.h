// A camera's picture in, the mouth's sizes out: key, regions, search, outline and gauge, one after the other.
#pragma once

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/mouth_gauge.h"
#include "appliance/programs/lips/mouth_search.h"
#include "appliance/programs/lips/outline.h"
#include "appliance/programs/lips/paint_key.h"
#include "appliance/programs/lips/paint_mask.h"
#include "appliance/programs/lips/region.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// One thread. Allocates nothing once it has seen a few pictures.
class LipMeter {
 public:
  // Goes on from `before`.
  LipMeter(const LipSettings& settings, const board::Lips& before)
      : key_(settings.paint, settings.key), search_(settings.marker), gauge_(before, settings.gauge) {}

  // The mouth in a picture that was true at `at`; looked for where the one before was.
  const board::Lips& Measure(const decode::Planes& planes, Time at);

  const board::Lips& lips() const { return gauge_.lips(); }

  // Of the picture that was measured last.
  const PaintMask& mask() const { return mask_; }
  const PaintKey& key() const { return key_; }
  const std::optional<Sight>& sight() const { return sight_; }

 private:
  void NoteSize(const decode::Plane& picture);
  std::optional<Sight> Look(const decode::Planes& planes, Time at);
  bool IsPaint(const decode::Planes& planes, const Region& mouth);

  PaintKey key_;
  PaintMask mask_;
  Regions regions_;
  MouthSearch search_;
  OutlineReader outline_;
  MouthGauge gauge_;
  std::optional<Sight> sight_;
  int width_px_ = 0;  // Of the last picture.
  int height_px_ = 0;
};

}  // namespace kaori::lips
