// What kaori-shows says, and how an update of the box goes on, which another program brings in.
#include <fcntl.h>

#include <utility>

#include "appliance/core/store/said.h"
#include "appliance/programs/shows/install_service.h"
#include "drivers/base/log.h"
#include "drivers/base/utf8.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

constexpr std::size_t kLongestReason = 160;  // Two lines of a small screen.

// With how far it is, where it is under way.
std::string SayOfUpdate(const update::Answer& answer, update::Language language) {
  const std::string done = answer.is_last() ? "" : std::to_string(answer.done / 10) + " %";
  const bool is_english = language == update::Language::kEnglish;
  return update::Say(answer.message, language, answer.version,
                     is_english && done.empty() ? answer.detail : done);
}

}  // namespace

void WriteSaid(const std::filesystem::path& file, const std::string& text) {
  if (auto ok = WriteWholeFile(file, {AsBytes(text)}); !ok) LogWarning("{}", ok.error().message());
}

// The stick's file goes over as it was opened here, where alone it is mounted.
void InstallService::CallUpdate(const Choosable& taken) {
  UniqueFd file;
  if (taken.kind == Choosable::Kind::kUpdate) {
    file = UniqueFd(::open(taken.offer.file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
    if (!file.valid())
      return TellOfUpdate({update::Message::kPulled, 0, 0, FailErrno("open it").value().message()});
  }
  auto caller = update::Caller::Ask(places_.update_socket, file.valid() ? update::kInstall : update::kRestart,
                                    file.get());
  if (!caller) return TellOfUpdate({update::Message::kDiskFault, 0, 0, caller.error().message()});
  update_ = std::move(*caller);
}

void InstallService::FollowUpdate() {
  auto answer = update_->Read();
  if (!answer && answer.error().cause == std::errc::resource_unavailable_try_again) return;
  if (!answer) answer = update::Answer{update::Message::kDiskFault, 0, 0, answer.error().message()};
  answer->detail = utf8::Printable(answer->detail, kLongestReason);
  if (answer->is_last()) {
    update_.reset();
    ListAnew();
    menu_.ForgetPresses();
  }
  TellOfUpdate(*answer);
}

void InstallService::Tell(Message message, const std::string& name, const std::string& reason) {
  const std::string detail = utf8::Printable(reason, kLongestReason);
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

void InstallService::TellOfUpdate(const update::Answer& answer) {
  const bool is_said = said_ && said_->of_update && said_->of_update->message == answer.message;
  said_ = Said{.of_update = answer};
  Show();
  if (is_said) return;
  const std::string line = SayOfUpdate(answer, update::Language::kEnglish) + " / " +
                           SayOfUpdate(answer, update::Language::kJapanese);
  if (update::IsRefusal(answer.message))
    LogWarning("{}", line);
  else
    Log("{}", line);
}

// A reason is English, so the Japanese line goes without; how far an update is, is a number.
std::string InstallService::Sentence(Language language) const {
  const bool is_english = language == Language::kEnglish;
  if (said_->of_update)
    return SayOfUpdate(*said_->of_update,
                       is_english ? update::Language::kEnglish : update::Language::kJapanese);
  return Say(said_->message, language, said_->name, is_english ? said_->detail : "");
}

bool InstallService::SaidIsRefusal() const {
  return said_->of_update ? update::IsRefusal(said_->of_update->message) : IsRefusal(said_->message);
}

// Both languages, one below the other, and the list below them.
void InstallService::Show() {
  const auto& [message, name, detail, of_stick, of_update] = *said_;
  const std::string mark(SaidIsRefusal() ? store::kRefusalMark : std::string_view());
  std::vector<std::string> lines = menu_.Lines(message, Language::kEnglish, name, detail, is_open_);
  lines.front() = mark + Sentence(Language::kEnglish) + "\n" + mark + Sentence(Language::kJapanese);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
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
  const bool asks = !said_ || (!said_->of_update &&
                               (said_->message == Message::kShut || said_->message == Message::kPlugIn));
  if (is_open_ && asks)
    Tell(Message::kChoose);
  else if (!is_open_ && !said_->of_update && said_->message == Message::kChoose)
    Tell(Message::kShut);
  else
    Show();
  said_->of_stick = of_stick;
}

}  // namespace kaori::shows
