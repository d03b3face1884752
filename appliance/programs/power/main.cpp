// kaori-power: what a short press of the PC's power button does, and why the box's last start ended.
//
// In a show it does nothing and says so; while the service key is on it stops the box. A long press is the
// hardware's, and to take the mains away is always safe. It lives as long as the box does, and so it notes when the
// box is stopped, and says after the next start how the one before ended.
#include <chrono>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "appliance/core/board/service_key.h"
#include "appliance/programs/power/last_start.h"
#include "appliance/programs/power/power_button.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/run_program.h"
#include "drivers/base/whole_file.h"

namespace {

constexpr std::string_view kHelp =
    R"(kaori-power: stops the box by its power button, while the service key is on; says how the last start ended

  --board FILE    the board, shared with the other programs (/run/kaori/board)
  --notice FILE   what the status picture says of a press that did nothing (/run/kaori-notices/power)
  --start FILE    whether this start runs or is stopped, for the next one; nothing is noted without it
)";

struct Settings {
  std::string board = "/run/kaori/board", notice = "/run/kaori-notices/power", start;
};

// What a press did, in English and Japanese.
struct Notice {
  const char* english;
  const char* japanese;
};
constexpr Notice kIgnored{
    "the power button was pressed: turn the service key on and press it again to stop the box",
    "電源ボタンが押されました。止めるには、サービスキーを入れてもう一度押してください"};
constexpr Notice kStops{"the power button was pressed with the service key on: the box stops",
                        "サービスキーが入った状態で電源ボタンが押されました。箱を止めます"};
constexpr unsigned kReadOnly = 0444;
// How long the notice stands: longer than somebody looks for it.
constexpr auto kNoticeStands = std::chrono::minutes(1);
constexpr auto kNoticePeriod = std::chrono::seconds(1);

// The notice of a press that did nothing is taken back after a while.
void ForgetNotice(const std::string& file) {
  std::error_code none;
  const auto written = std::filesystem::last_write_time(file, none);
  if (!none && std::filesystem::file_time_type::clock::now() - written >= kNoticeStands)
    std::filesystem::remove(file, none);
}

// The board is opened at each press, since it may have been made anew. The notice is written before the box
// stops, so that the status picture says why.
void HandlePress(const Settings& settings) {
  const bool stops = kaori::board::IsServiceKeyOnAt(settings.board);
  const auto& [english, japanese] = stops ? kStops : kIgnored;
  kaori::LogWarning("{} / {}", english, japanese);
  const std::string notice = std::string(english) + "\n" + japanese + "\n";
  if (auto told = kaori::WriteWholeFile(settings.notice, {kaori::AsBytes(notice)}, kReadOnly); !told)
    kaori::LogWarning("{}", told.error().message());
  if (!stops) return;
  kaori::ExpectLongCall();
  const auto status = kaori::RunProgram({"/bin/systemctl", "poweroff"});
  if (!status || *status != 0)
    kaori::LogError("systemctl poweroff: {}", status ? std::to_string(*status) : status.error().message());
}

// Without a data partition nothing is known of starts before, and the show goes on.
void SayHowTheLastStartEnded(kaori::power::LastStart& start) {
  const auto said = start.Begin();
  if (!said)
    kaori::LogWarning("{}", said.error().message());
  else if (!said->empty())
    kaori::Log("{}", *said);
}

// Runs until the program is told to end, which the service manager does when the box stops.
kaori::Result<void> ListenTo(std::vector<kaori::power::PowerButton>& buttons, const Settings& settings,
                             kaori::EventLoop& loop) {
  for (kaori::power::PowerButton& button : buttons) {
    const auto read = [&] {
      const auto pressed = button.ReadPress();
      if (pressed && *pressed) HandlePress(settings);
      if (pressed) return;
      kaori::LogWarning("{}", pressed.error().message());
      loop.Forget(button.fd());
    };
    if (auto watched = loop.Watch(button.fd(), read); !watched) return watched;
  }
  return loop.RunEvery(kNoticePeriod, [&] { ForgetNotice(settings.notice); });
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-power");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Text("--notice", settings.notice).Text("--start", settings.start);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return kaori::ExitWithError(ok.error());
  std::vector<kaori::power::PowerButton> buttons = kaori::power::PowerButton::FindAll();
  if (buttons.empty()) kaori::Log("this machine has no power button");
  kaori::power::LastStart start(settings.start, {});
  kaori::ExpectSlowDisk();
  if (!settings.start.empty()) SayHowTheLastStartEnded(start);
  if (auto ran = ListenTo(buttons, settings, *loop); !ran) return kaori::ExitWithError(ran.error());
  if (settings.start.empty()) return 0;
  kaori::ExpectSlowDisk();
  if (auto noted = start.NoteStop(); !noted) kaori::LogWarning("{}", noted.error().message());
  return 0;
}
