// Pictures for surfaces with screens in their keys: of every call that a button may have.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// For each shape of deck (decode::kDeckShapes) and each call but the numbers of cues, as DeckPictures looks for them:
//   FOLDER/72/SUM.jpg       dimmed, and SUM-lit.jpg bright and framed; SUM is roles::SumOfCall in hexadecimal digits
//   FOLDER/72/blank.jpg     of a key that calls nothing
// Files that are there already are replaced, and others stay, so that a folder may have the pictures of several
// shows. Uses the studio's GL context, so it must be called on the thread that opened it. Takes seconds. `step` hears what is
// being drawn. Returns how many calls have pictures. Errors: those of the file system, of the font and of drawing.
Result<int> DrawKeys(stage::Studio& studio, const std::filesystem::path& folder,
                     const std::function<void(std::string_view)>& step);

}  // namespace kaori::authoring
