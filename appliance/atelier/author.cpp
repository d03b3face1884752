#include "appliance/atelier/author.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/atelier/script/show_file.h"
#include "appliance/atelier/sculpt/sculpt.h"
#include "appliance/atelier/wardrobe/dress.h"
#include "appliance/show/check.h"

namespace kaori::atelier {
namespace {

tl::unexpected<Error> FailAll(const std::vector<std::string>& faults) {
  return FailInput(fmt::format("{}", fmt::join(faults, "\n")));
}

}  // namespace

Result<show::Show> AuthorShow(const std::filesystem::path& folder, const Progress& progress) {
  show::Show show;
  progress("sculpting the faces and their expressions");
  if (auto ok = sculpt::Sculpt(folder, show.cast); !ok) return tl::unexpected(ok.error());
  progress("painting, hair, clothes and shadows");
  if (auto ok = wardrobe::Dress(folder, show.cast); !ok) return tl::unexpected(ok.error());
  progress("reading the script");
  if (const auto faults = ReadShowFile(folder / "show.toml", show); !faults.empty()) return FailAll(faults);
  if (const auto faults = show::CheckShow(show); !faults.empty()) return FailAll(faults);
  return show;
}

}  // namespace kaori::atelier
