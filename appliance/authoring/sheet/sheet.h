// Contact sheets: every face with every expression, every style, every way of looking, to be looked at.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// How large, and how thoroughly.
struct SheetOptions {
  // At least 64; cells of the grid of the whole cast are half as large.
  int cell_width_px = 320;
  int cell_height_px = 360;
  // Looks for flaws: seconds, and minutes for a cast with a hundred channels.
  bool inspects = true;
};

// Draws PNG files, looks for flaws, and writes into `folder` (made if need be):
//   cast.png         a row for each face, a column for each expression
//   faces.png        each face from five sides
//   styles.png       each face in the five styles
//   morphs.png       from the first face to each other one; only where there is another
//   face-NAME.png    one face with every expression, mouth shape, lid and channel
//   index.html       all of it for a browser, to be searched; opens from the disk
// Flaws that an audience must not see (inspect::Inspect) are framed in red. Everything is drawn first and
// written last, each file whole; where something fails before, nothing is written, and a folder that was made
// is removed. `wrote` hears each file's path, `step`, where there is one, what is being done.
//
// Uses the studio's GL context, so it must be called on the thread that opened it. Takes seconds, and the
// memory of all pictures at once. Errors: those of the file system, of the font and of drawing.
Result<void> DrawSheets(stage::Studio& studio, const std::filesystem::path& folder,
                        const SheetOptions& options, const std::function<void(std::string_view)>& wrote,
                        const std::function<void(std::string_view)>& step = {});

}  // namespace kaori::authoring
