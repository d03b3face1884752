#include "appliance/programs/report/logged_show.h"

#include <fmt/format.h>

#include "appliance/core/last_face/show_mark.h"
#include "appliance/core/roles/roles_file.h"
#include "appliance/core/show/pack.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/report/own_copy.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::report {

// The log carries the roles of its evening; they are laid over the show by way of a file, as the box does it.
// The editor is opened for the expressions that it appends to the show, on which the numbers of the log
// count. A pack whose mark cannot be read is not refused.
Result<show::Show> LoadShowOfLog(const std::filesystem::path& pack, const showlog::LogHead& head,
                                 const std::filesystem::path& own) {
  auto show = show::LoadPack(pack);
  if (!show) return tl::unexpected(show.error());
  if (const auto mark = last_face::ShowMark(pack); mark && *mark != head.show)
    return FailInput(
        fmt::format("{}: the show log is of another show, or of another version of this one", pack.string()));
  const TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  if (folder.empty()) return FailErrno("make a folder for the roles of the show log");
  if (!head.roles.empty()) {
    const auto file = folder / "roles.toml";
    if (auto written = WriteWholeFile(file, {AsBytes(head.roles)}); !written)
      return tl::unexpected(written.error());
    roles::Besides besides;
    const auto faults = roles::LayOver(file, roles::ItemsOf(*show), show->roles, besides);
    roles::Assign(besides.buttons, *show);
    for (const std::string& fault : faults) LogWarning("{}", fault);
  }
  editor::ExpressionEditor::Open(own.empty() ? folder / "own" : own, *show);
  return show;
}

}  // namespace kaori::report
