#include "appliance/programs/stage/loading.h"

#include <chrono>
#include <system_error>
#include <utility>

#include "appliance/core/show/pack.h"
#include "appliance/programs/stage/last_face.h"
#include "appliance/programs/stage/show_log.h"
#include "drivers/base/log.h"
#include "drivers/base/service.h"
#include "drivers/base/start_watch.h"

namespace kaori::stage {
namespace {

// All of a show is read before it is believed: from now on the start may take as long as a slow disk does.
void AllowReading(const std::filesystem::path& pack) {
  constexpr std::uintmax_t kSlowDisk_bytes_s = std::uintmax_t{1} << 20U;
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(pack, none);
  const std::chrono::seconds reading(none ? 0 : bytes / kSlowDisk_bytes_s);
  if (auto told = service::ExtendStart(service::StartWatch::kFirstStep + reading); !told)
    LogWarning("{}", told.error().message());
}

}  // namespace

Result<ShowPlaces> PlacesOf(const StageOptions& options) {
  auto trusted = show::LoadOptionsOf(options.trust, options.verified);
  if (!trusted) return tl::unexpected(trusted.error());
  const std::filesystem::path shows = options.shows, board = options.board;
  return ShowPlaces{.root_pack = options.pack,
                    .shows = shows,
                    .keys = shows.parent_path() / "settings" / "keys",
                    .play_log = store::PlayLogBeside(board),
                    .chosen = options.chosen,
                    .key_files = options.keys,
                    .of_root = std::move(*trusted),
                    .before_reading = AllowReading};
}

std::filesystem::path OwnFolder(const StageOptions& options) {
  return options.own.empty() ? editor::UsualFolder() : std::filesystem::path(options.own);
}

Result<Loaded> LoadShow(const StageOptions& options, const ShowPlaces& places) {
  auto chosen = LoadChosen(places, SteadyClock().now());
  if (!chosen) return tl::unexpected(chosen.error());
  auto& show = chosen->show;
  Log("{} is read", show.name);
  const std::filesystem::path own = OwnFolder(options);
  auto own_roles = OwnRolesOver(show, own / "roles.toml");
  LayOverRoles(own_roles, show);
  auto editor = editor::ExpressionEditor::Open(own, show);
  showlog::LogHead head;
  if (!options.log.empty())
    head = HeadOfLog(ShowMark(chosen->pack).value_or(0), own / "roles.toml", SteadyClock().now());
  return Loaded{std::move(editor), std::move(own_roles), std::make_unique<PreparedShow>(std::move(show)),
                std::move(head),   chosen->pack,         chosen->generation,
                chosen->another};
}

}  // namespace kaori::stage
