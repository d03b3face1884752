// The page that shows contact sheets in a browser.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/sheet/layout.h"
#include "appliance/authoring/sheet/plan.h"

namespace kaori::authoring {

// A sheet and where its parts stand.
struct LaidOut {
  Sheet sheet;
  Layout layout;
};

// One file that needs nothing but the pictures beside it, and opens from the disk without a server: each cell
// can be found by face, by name and by flaw, and is shown large when it is clicked. `about` is a line below
// the show's name. Texts of the show are escaped; no name can become markup.
std::string Page(const std::vector<LaidOut>& sheets, const std::string& show, const std::string& about);

}  // namespace kaori::authoring
