#include "appliance/authoring/author.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/appearance/dress.h"
#include "appliance/authoring/mesh/sparse_triangles.h"
#include "appliance/authoring/script/show_file.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/core/show/check.h"

namespace kaori::authoring {
namespace {

// One fault a line, as every reader's error is.
tl::unexpected<Error> FailAll(const std::vector<std::string>& faults) {
  return FailInput(fmt::format("{}", fmt::join(faults, "\n")));
}

}  // namespace

// The order is fixed by what each step reads: looks are painted on the sculpted cage and shaded with its
// hair, the script names faces and expressions, and the last check sees the show as a pack would hold it.
Result<show::Show> AuthorShow(const std::filesystem::path& folder, const Progress& progress) {
  show::Show show;
  progress("sculpting the faces and their expressions");
  if (auto ok = sculpt::Sculpt(folder, show.cast); !ok) return tl::unexpected(ok.error());
  progress("painting, hair, clothes and shadows");
  if (auto ok = appearance::Dress(folder, show.cast); !ok) return tl::unexpected(ok.error());
  progress("reading the script");
  if (const auto faults = ReadShowFile(folder / "show.toml", show); !faults.empty()) return FailAll(faults);
  if (const auto faults = show::CheckShow(show); !faults.empty()) return FailAll(faults);
  progress("leaving out triangles where faces are flat");
  mesh::LeaveOutFlat(show.cast);
  return show;
}

}  // namespace kaori::authoring
