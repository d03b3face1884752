// A long cue list for a show that has none so long.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "appliance/core/show/show.h"

namespace kaori::tests {

// The show with `count` cues from 1 on, each of which GO plays: faces and expressions in turn, with fades. It has no lobby.
inline show::Show WithManyCues(show::Show show, std::size_t count) {
  show.lobby.reset();
  show.cue_list.cues.clear();
  for (std::size_t n = 0; n < count; ++n) {
    show::Cue cue;
    cue.number = std::to_string(n + 1);
    cue.name = "cue " + cue.number;
    cue.notes = "Nothing is said here of cue " + cue.number + ".";
    cue.face = show::CueCall{static_cast<std::uint16_t>(n % show.cast.faces.size()), 0.3F};
    cue.expression = show::CueCall{static_cast<std::uint16_t>(n % show.cast.expressions.size()), 0.5F};
    cue.light = show::CueLevel{n % 2 == 0 ? 1.0F : 0.8F, 0.4F};
    show.cue_list.cues.push_back(std::move(cue));
  }
  show::Track(show);
  return show;
}

}  // namespace kaori::tests
