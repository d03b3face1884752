// The page of the contact sheets as it stands in page.html, carried in the program.
#pragma once

#include <string_view>

namespace kaori::authoring {

// Contains "@DATA@" once, which stands for the sheets' description, JSON.
extern const std::string_view kSheetPage;

}  // namespace kaori::authoring
