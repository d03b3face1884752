// kaori-stage: draws the face that the board describes.
#include "appliance/board/board.h"
#include "appliance/needles/needles.h"
#include "appliance/show/pack.h"
#include "appliance/stage/seat.h"
#include "appliance/stage/stage.h"
#include "appliance/stage/studio.h"
#include "drivers/base/alarm.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/service.h"
#include "drivers/scanout/kms_screen.h"
#include "drivers/scanout/local_screen.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-stage: draws the face that the board describes

  --board FILE    the board, shared with the other programs
  --pack FILE     the show
  --trust FILE    a public key: play no show that it has not signed
  --own FOLDER    where expressions made with the needles are kept (/var/lib/kaori/own where it is there, else
                  $XDG_STATE_HOME/kaori/own)
  --links FOLDER  the simulator's link folder, in which the screen is plugged
  --card FILE     instead: the graphics card, as in /dev/dri/card0
  --early         read the hands right after each flip, not as late as drawing allows: to compare
)";

struct Settings {
  std::string board, pack, links, card, trust, own;
  bool early = false;
};

int Complain(const kaori::Error& error) {
  kaori::Log("{}", error.message());
  return 1;
}

// A graphics card: the file through which it shows, which outlives this program where a service manager
// keeps it, and the one through which it draws.
struct Card {
  kaori::UniqueFd shows;
  kaori::scanout::GbmDevice draws;
};

kaori::Result<Card> OpenCard(const std::string& path) {
  constexpr std::string_view kName = "card";
  auto kept = kaori::service::TakeKept(kName);
  auto shows =
      kept ? kaori::Result<kaori::UniqueFd>(std::move(*kept)) : kaori::scanout::KmsCard::Open(path.c_str());
  if (!shows) return tl::unexpected(shows.error());
  if (auto ready = kaori::scanout::KmsCard::Prepare(shows->get()); !ready)
    return tl::unexpected(ready.error());
  if (!kept) {
    if (auto safe = kaori::service::Keep(shows->get(), kName); !safe)
      kaori::Log("{}", safe.error().message());
  }
  auto draws = kaori::scanout::GbmDevice::Open(path.c_str(), shows->get());
  if (!draws) return tl::unexpected(draws.error());
  return Card{std::move(*shows), std::move(*draws)};
}

// Without one on a desk, where the simulator's screen is looked for.
kaori::Result<Card> CardOf(const Settings& settings) {
  return settings.card.empty() ? Card() : OpenCard(settings.card);
}

kaori::Result<kaori::show::Show> LoadShow(const Settings& settings) {
  if (settings.trust.empty()) return kaori::show::LoadPack(settings.pack);
  const auto key = kaori::show::ReadPublicKey(settings.trust);
  if (!key) return tl::unexpected(key.error());
  return kaori::show::LoadPack(settings.pack, {.signed_by = *key});
}

int Play(const Settings& settings, kaori::EventLoop& loop) {
  const auto card = CardOf(settings);
  if (!card) return Complain(card.error());
  auto show = LoadShow(settings);
  if (!show) return Complain(show.error());
  kaori::Log("{} is read", show->name);
  const auto board = kaori::board::Board::Create(settings.board);
  if (!board) return Complain(board.error());
  auto writers = kaori::stage::StageWriters::Take(*board);
  if (!writers) return Complain(writers.error());
  auto needles = kaori::needles::Needles::Open(
      settings.own.empty() ? kaori::needles::UsualFolder() : std::filesystem::path(settings.own), *show);
  const auto studio = kaori::stage::Studio::Open(std::move(*show), card->draws.device.get());
  if (!studio) return Complain(studio.error());
  const kaori::SteadyClock clock;
  kaori::stage::Stage stage(*board, std::move(*writers), **studio, clock);
  stage.Bring(std::move(needles));
  kaori::Log("{} is {} on {}", (*studio)->show().name, stage.resumed() ? "resumed" : "opened",
             (*studio)->renderer());
  auto alarm = kaori::Alarm::Make();
  if (!alarm) return Complain(alarm.error());
  if (!settings.early) stage.DrawLate();
  kaori::stage::Seat seat(stage, loop, std::move(*alarm), [&] {
    if (settings.card.empty()) return kaori::scanout::LocalScreen::Open(settings.links);
    return kaori::scanout::KmsScreen::Open(card->shows.get(), card->draws.device.get());
  });
  if (auto seated = seat.Take(); !seated) return Complain(seated.error());
  kaori::Log("the first picture is drawn");
  if (auto told = kaori::service::Tell("READY=1"); !told) kaori::Log("{}", told.error().message());
  if (auto played = loop.Run(); !played) return Complain(played.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::SetLogName("kaori-stage");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board, true)
      .Text("--pack", settings.pack, true)
      .Text("--links", settings.links)
      .Text("--card", settings.card);
  options.Text("--trust", settings.trust).Text("--own", settings.own).Switch("--early", settings.early);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.card.empty() == settings.links.empty()) {
    kaori::Log("where is the screen? Give one of --links and --card");
    return 2;
  }
  auto loop = kaori::EventLoop::Open();
  if (!loop) return Complain(loop.error());
  return Play(settings, *loop);
}
