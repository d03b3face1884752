// Pictures for surfaces with screens in their keys: of every call that a button may have.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "appliance/core/show/pack_keys.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// Gets each picture as soon as it is drawn; an error of its own ends the drawing.
using KeySink = std::function<Result<void>(show::KeyPicture)>;

// For each shape of deck (decode::kDeckShapes) and each call but the numbers of cues both states, dimmed, and bright with a
// frame; and one of a key that calls nothing. Uses the studio's GL context, so it must be called on the thread that opened it.
// Takes seconds. `step` hears what is being drawn. Returns how many calls have pictures. Errors: those of the sink, of
// the font and of drawing.
Result<int> DrawKeys(stage::Studio& studio, const KeySink& sink,
                     const std::function<void(std::string_view)>& step);

// A sink that writes files, as DeckPictures looks for them:
//   FOLDER/72/SUM.jpg       dimmed, and SUM-lit.jpg bright and framed; SUM is roles::SumOfCall in hexadecimal digits
//   FOLDER/72/blank.jpg     of a key that calls nothing
// Files that are there already are replaced, and others stay, so that a folder may have the pictures of several
// shows. The folders are made now. Errors: those of the file system.
Result<KeySink> KeyFiles(std::filesystem::path folder);

}  // namespace kaori::authoring
