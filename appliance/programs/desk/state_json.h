// The state of the lips as JSON for the page, and the language that a visitor reads.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/protocol/protocol.h"
#include "drivers/base/clock.h"

namespace kaori::desk {

// What a state is made of; `now` is the time at which ages are told.
struct DeskFacts {
  board::Stamped<board::Lips> lips;
  board::Stamped<board::StageStatus> stage;
  std::optional<lips::Report> report;  // Empty while the lips do not answer.
  std::uint32_t picture = 0;           // The number of the newest picture; 0: there is none.
  // On the board's clock; ages are told for this moment.
  Time now{};
};

// {"lips": bool, "camera": "absent" | "live" | "stale",
//  "mouth": {"height", "width", "opening", "quality", "age_ms", "learnable": bool, "open", "wide"},
//  "presented_age_ms": number or null, "picture": number,
//  "report": null or {"answered", "complaint", "step": text or null, "progress", "done": [text..], "changes",
//                     "unsaved", "saved", "before", "exposure_free",
//                     "box": [left, top, right, bottom] or null,
//                     "settings": {name: {"value", "low", "high"}..}}}
// "mouth" has the values of board::Lips and of board::MouthPosition; "presented_age_ms" is how old the lips
// are when the picture that shows them is presented; the rest is lips::Report.
std::string StateJson(const DeskFacts& facts);

// Whether `accept_language`, the header as browsers send it, prefers Japanese to English. Pure; any text is
// safe.
bool PrefersJapanese(std::string_view accept_language);

}  // namespace kaori::desk
