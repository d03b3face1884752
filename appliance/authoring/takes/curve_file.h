// Reads curves as files have them: pairs [seconds, value].
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/takes/curve_names.h"
#include "appliance/core/toml/section.h"

namespace kaori::authoring {

struct CurveRules {
  const CurveName* name = nullptr;  // Null: a channel.
  bool rests = true;                // It must begin and end at 0; of what was recorded the tool sees to that.
};

// The keys in the file's unit: degrees, centimetres or weights. What is wrong is added to the faults under
// `item`, with the line of its pair; all pairs are read, so that one fault does not hide the next.
std::vector<show::MotionKey> ReadCurveKeys(toml::Faults& faults, const std::string& item,
                                           const toml::Value& pairs, const CurveRules& rules);

}  // namespace kaori::authoring
