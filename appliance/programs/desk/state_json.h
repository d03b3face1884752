// What the page is told of the lips, as JSON.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/service/words.h"
#include "drivers/base/clock.h"

namespace kaori::desk {

struct DeskFacts {
  board::Stamped<board::Lips> lips;
  board::Stamped<board::StageStatus> stage;
  std::optional<lips::Report> report;  // Nothing: the lips are gone.
  std::uint32_t picture = 0;           // Number of the newest one; 0: none.
  Time now{};
};

// {"lips": bool, "camera": "absent" | "live" | "stale",
//  "mouth": {"height", "width", "opening", "quality", "age_ms", "open", "wide"},
//  "light_age_ms": number or null, "picture": number,
//  "report": null or {"answered", "complaint", "step": text or null, "progress", "taken": [text..],
//  "changes",
//                     "unsaved", "saved", "before", "free_light", "box": [left, top, right, bottom] or null,
//                     "settings": {name: {"value", "low", "high"}..}}}
std::string StateJson(const DeskFacts& facts);

// Whether somebody who reads `accept_language` (as browsers send it) would rather read Japanese than English.
bool PrefersJapanese(std::string_view accept_language);

}  // namespace kaori::desk
