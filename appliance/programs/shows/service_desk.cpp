// The part of InstallService that speaks with the desk: its visitors see the list and take lines of it, as whoever stands before the
// box does, and bring settings as a stick does.
#include <utility>

#include "appliance/programs/shows/desk_link.h"
#include "appliance/programs/shows/install_service.h"
#include "drivers/base/json.h"
#include "drivers/base/log.h"
#include "drivers/base/utf8.h"

namespace kaori::shows {
namespace {

// Five times a second look like at once to whoever waits for an answer on a page.
constexpr Duration kTellPeriod = std::chrono::milliseconds(200);
constexpr std::size_t kLongestBrought = 60;  // A line of a small screen has room for more.
constexpr const char* kOfDesk = "settings of the desk";

}  // namespace

bool InstallService::IsBusy() const {
  return writes_support_ || installation_ || update_ || (of_box_.copies != nullptr && of_box_.copies->busy());
}

// What comes while something is on its way is dropped: the page says that the box is busy. A line of a list that is no longer the one
// of now is dropped too, since its visitor meant another one.
void InstallService::HearDesk() {
  auto request = of_box_.desk->Hear();
  if (!request || IsBusy()) return;
  tell_next_ = {};
  // Whoever brings something has not agreed to what is asked: a yes would be one to another question.
  if (request->kind != Request::Kind::kTake) DropQuestion();
  if (request->kind == Request::Kind::kBackup || request->kind == Request::Kind::kRestore) {
    if (of_box_.copies != nullptr) CopyForDesk(std::move(*request));
  } else if (request->kind == Request::Kind::kSettings) {
    if (of_box_.settings == nullptr) return;
    Log("the desk brings settings");
    TellOfSettings(of_box_.settings->BeginText(kOfDesk, request->text), false);
  } else if (const auto taken = menu_.LineOf(request->list, request->line)) {
    Log("the desk takes \"{}\"", taken->offer.name);
    Accept(*taken);
  }
}

// The list is that of shows until it asks.
void InstallService::CopyForDesk(Request request) {
  BoxCopies& copies = *of_box_.copies;
  const bool restores = request.kind == Request::Kind::kRestore;
  ListAnew();
  Log("the desk {}", restores ? "brings a backup" : "wants a backup");
  const Progress progress = restores ? copies.BeginRestore(utf8::Printable(request.text, kLongestBrought),
                                                           std::move(request.file), Keys())
                                     : copies.BeginForDesk();
  Tell(progress.message, copies.name(), progress.detail);
}

// Of what asks for a press of the box's own keys nothing is said there.
std::string InstallService::StateForDesk() const {
  const bool is_said = said_ && (said_->of_update || said_->message != Message::kShut);
  json::Object state{{"box", of_box_.copies == nullptr ? std::string() : of_box_.copies->box()},
                     {"list", menu_.number()},
                     {"choices", json::ListOf(menu_.Labels())},
                     {"more", menu_.left_out()},
                     {"notes", json::ListOf(menu_.notes())},
                     {"busy", IsBusy()},
                     {"said", json::Object{{"en", is_said ? Sentence(Language::kEnglish) : ""},
                                           {"ja", is_said ? Sentence(Language::kJapanese) : ""},
                                           {"refused", is_said && SaidIsRefusal()}}}};
  const std::string& given = of_box_.desk->given();
  state.emplace_back("backup", given.empty() ? json::Value() : json::Value(given));
  json::Object whole = state;
  whole.emplace_back("settings",
                     of_box_.settings == nullptr ? json::Value() : json::Value(of_box_.settings->Text()));
  std::string text = json::Write(std::move(whole));
  if (text.size() <= kLongestState_bytes) return text;
  // A file of settings that no packet holds, because of what it is: the rest of the state counts all the same.
  state.emplace_back("settings", json::Value());
  return json::Write(std::move(state));
}

// A backup of a desk that is gone goes with its descriptor: nobody fetches it any more.
void InstallService::TellDesk(Time now) {
  auto backup = of_box_.copies == nullptr ? std::nullopt : of_box_.copies->ReleaseForDesk();
  if (backup && of_box_.desk->connected())
    if (auto ok = of_box_.desk->Give(backup->name, std::move(backup->file)); !ok)
      LogWarning("{}", ok.error().message());
  if (!of_box_.desk->connected() || now < tell_next_) return;
  tell_next_ = now + kTellPeriod;
  of_box_.desk->Tell(StateForDesk());
}

}  // namespace kaori::shows
