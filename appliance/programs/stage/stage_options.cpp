#include "appliance/programs/stage/stage_options.h"

#include <string_view>

#include "appliance/programs/stage/quality_choice.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"

namespace kaori::stage {
namespace {

constexpr std::string_view kStageHelp = R"(kaori-stage: draws the face that the board describes

  --board FILE    the board, shared with the other programs
  --pack FILE     the show
  --trust FILE    a public key, or a folder of them: play no show that none of them has signed
  --shows FOLDER  shows that were brought to the box: the one that is chosen there is played instead, where a key in the
                  folder `keys` beside --pack, or beside FOLDER in settings/keys, has signed it
  --chosen FILE   where kaori-shows says that another show is chosen; the stage then ends, to be started with that one
  --rehearse FILE instead of all this: reads this pack, draws each of its scenes once without a screen, and says by its
                  status whether it plays
  --verified      the show lies on a root whose every block the kernel checks: its checksum is not made again
  --own FOLDER    where the box's own roles.toml lies, and expressions that are made on it are kept (/var/lib/kaori/own where it is there, else
                  $XDG_STATE_HOME/kaori/own)
  --last-face FILE  the last face is kept there, and the show goes on with it when the box is switched on
  --trial FILE    while this file is there, and that of --settled is not, no last face is kept: the one that lies there is what an update
                  is judged by
  --settled FILE  says that the trial is over
  --evening FILE  plays the evening of this show log again, without the part of one operator, who is live: minus one
  --without ROLE  whose part that is; "lips" is that of lips and voice
  --at TIME       where it begins, by the clock of that evening, as in 19:43:10
  --log FOLDER    keeps the show log there: what each frame was made of, three evenings of it
  --links FOLDER  the simulator's link folder, in which the screen is plugged
  --card FILE     instead: the graphics card, as in /dev/dri/card0; auto: the first one that has sockets for screens
  --mode MODE     how all its screens are shown, as in 1280x720@50, not as they ask themselves
  --quality Q     how finely it draws: basic for processors, fine or finest for graphics cards, auto (usual): what this machine draws in time
  --settings FOLDER what the box was told when it started (/run/kaori-profile)
  --fdkeeper SOCKET where the card is kept while no stage runs
  --still FILE    writes the show's first moment there, as a PPM
  --looked-at FILE while this file is there, what is shown is written each second to look.ppm beside the board
  --keys FOLDER   in memory: pictures for keys with screens, which the show brings, are laid out there
  --early         sample the input right after each flip, not as late as drawing allows: to compare
)";

}  // namespace

// A rehearsal needs nothing but its pack. Whoever plays needs a board, a show, and a screen of one kind: that
// of the simulator or a graphics card.
std::optional<int> ParseOptions(int argc, char** argv, StageOptions& into) {
  Options options(kStageHelp);
  options.Text("--board", into.board)
      .Text("--pack", into.pack)
      .Text("--links", into.links)
      .Text("--card", into.card);
  options.Text("--trust", into.trust)
      .Text("--shows", into.shows)
      .Text("--chosen", into.chosen)
      .Text("--rehearse", into.rehearse)
      .Text("--last-face", into.last_face)
      .Text("--own", into.own)
      .Text("--log", into.log)
      .Text("--evening", into.evening.log)
      .Text("--without", into.evening.without)
      .Text("--at", into.evening.at)
      .Text("--mode", into.mode)
      .Text("--quality", into.quality)
      .Text("--settings", into.settings)
      .Text("--fdkeeper", into.fdkeeper)
      .Text("--still", into.still)
      .Text("--looked-at", into.looked_at)
      .Text("--trial", into.trial)
      .Text("--settled", into.settled)
      .Text("--keys", into.keys)
      .Switch("--early", into.early)
      .Switch("--verified", into.verified);
  if (const auto status = options.Parse(argc, argv)) return status;
  if (!IsQualityWish(into.quality)) {
    LogError("{}", NoQualityWish(into.quality));
    return 2;
  }
  if (!into.rehearse.empty()) return std::nullopt;
  if (into.board.empty() || into.pack.empty()) {
    LogError("this option is needed: {}", into.board.empty() ? "--board" : "--pack");
    return 2;
  }
  if (into.card.empty() == into.links.empty()) {
    LogError("where is the screen? Give one of --links and --card");
    return 2;
  }
  return std::nullopt;
}

StillFiles StillFilesOf(const StageOptions& options) {
  return {options.still, options.looked_at, std::filesystem::path(options.board).parent_path() / "look.ppm"};
}

}  // namespace kaori::stage
