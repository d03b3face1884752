// What InstallService says on the screen and in the log.
#include "appliance/core/store/said.h"
#include "appliance/programs/shows/install_service.h"
#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kLongestReason = 160;  // Two lines of a small screen.

}  // namespace

void WriteSaid(const std::filesystem::path& file, const std::string& text) {
  if (auto ok = WriteWholeFile(file, {AsBytes(text)}); !ok) LogWarning("{}", ok.error().message());
}

void InstallService::Tell(Message message, const std::string& name, const std::string& reason) {
  const std::string detail = Printable(reason, kLongestReason);
  const bool is_said = said_ && said_->message == message && said_->name == name && said_->detail == detail;
  said_ = Said{message, name, detail};
  Show();
  if (is_said) return;
  const std::string line =
      Say(message, Language::kEnglish, name, detail) + " / " + Say(message, Language::kJapanese, name);
  if (IsRefusal(message))
    LogWarning("{}", line);
  else
    Log("{}", line);
}

void InstallService::TellOfStick(Message message, const std::string& reason) {
  Tell(message, {}, reason);
  said_->of_stick = true;
}

// Both languages, one below the other; the screen shows those lines that its font has letters for.
void InstallService::Show() {
  const auto& [message, name, detail, of_stick] = *said_;
  const std::string mark(IsRefusal(message) ? store::kRefusalMark : std::string_view());
  std::string text = mark;
  for (const std::string& line : menu_.Lines(message, Language::kEnglish, name, detail, is_open_))
    text += line + "\n";
  text += mark + Say(message, Language::kJapanese, name) + "\n";
  if (!is_open_ && !menu_.empty() && message != Message::kShut)
    text += "  " + std::string(Words(Message::kShut, Language::kJapanese)) + "\n";
  if (text == shown_) return;
  shown_ = text;
  WriteSaid(places_.report / "lines", text);
}

// A message that only asks for a press gives way to the one that asks for the next; others stay.
void InstallService::FollowMenu(Time now) {
  if (is_open_ == menu_.IsOpen(now)) return;
  is_open_ = menu_.IsOpen(now);
  const bool of_stick = said_ && said_->of_stick;
  const bool asks = !said_ || said_->message == Message::kShut || said_->message == Message::kPlugIn;
  if (is_open_ && asks)
    Tell(Message::kChoose);
  else if (!is_open_ && said_->message == Message::kChoose)
    Tell(Message::kShut);
  else
    Show();
  said_->of_stick = of_stick;
}

}  // namespace kaori::shows
