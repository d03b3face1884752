// kaori-status: prints the status of the box, or draws it as a picture.
//
// It looks once, writes to standard output, and ends: with status 0 whatever the box is missing, 1 where
// there is no board or the picture cannot be written, and 2 where it is misused. It changes nothing on the
// box.
#include <cstdio>

#include "appliance/programs/status/facts.h"
#include "appliance/programs/status/lines.h"
#include "appliance/programs/status/sheet.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-status: prints the status of the box

  --board FILE      the board, shared with the other programs (/run/kaori/board)
  --settings FOLDER the settings with which the box was started (/run/kaori-profile)
  --picture FILE    draw the status to this PNG file, too
  --size WxH        the size of the picture in pixels (1280x720)
)";

struct Settings {
  std::string board = "/run/kaori/board", settings = "/run/kaori-profile", picture, size = "1280x720";
};

// Board::Open and not Create: whoever looks at a box that is not running makes no board. The stage's file of
// screens lies beside the board.
int Tell(const Settings& settings, kaori::Size size) {
  namespace status = kaori::status;
  const auto board = kaori::board::Board::Open(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  const std::filesystem::path screens = std::filesystem::path(settings.board).parent_path() / "screens";
  const auto facts = status::ReadFacts({settings.settings, screens});
  const auto lines = status::Describe(status::Look(*board, facts, kaori::SteadyClock().now()));
  std::fputs(status::TextOf(lines).c_str(), stdout);
  if (settings.picture.empty()) return 0;
  const auto picture = status::DrawAll(lines, size.width_px, size.height_px);
  if (!picture) return kaori::ExitWithError(picture.error());
  if (auto written = kaori::image::WritePng(settings.picture, *picture); !written)
    return kaori::ExitWithError(written.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-status");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Text("--settings", settings.settings);
  options.Text("--picture", settings.picture).Text("--size", settings.size);
  if (const auto status = options.Parse(argc, argv)) return *status;
  const auto size = kaori::ParseSize(settings.size);
  if (!size) return kaori::LogError("--size {}: expected width and height, as in 1280x720", settings.size), 2;
  return Tell(settings, *size);
}
