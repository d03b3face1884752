// The part of InstallService that has to do with backups and restores.
#include "appliance/programs/shows/install_service.h"
#include "appliance/programs/shows/offers.h"

namespace kaori::shows {

std::vector<Choosable> InstallService::WaysBackOnBox(bool has_stick) const {
  std::vector<Choosable> ways = WaysBack(folder_);
  for (Choosable& way : WaysOn(places_.pending, places_.before)) ways.push_back(std::move(way));
  if (of_box_.copies != nullptr)
    for (Choosable& each : of_box_.copies->Offers(has_stick)) ways.push_back(std::move(each));
  if (of_box_.settings != nullptr) ways.push_back(BoxSettings::Opening());
  return ways;
}

// A backup needs a stick; what a restore took away does not.
void InstallService::AcceptCopy(const Choosable& taken) {
  const bool answers = taken.kind == Choosable::Kind::kYes || taken.kind == Choosable::Kind::kNo;
  const Progress progress =
      answers ? of_box_.copies->Answer(taken.kind == Choosable::Kind::kYes)
              : of_box_.copies->Begin(taken, stick_.value_or(std::filesystem::path()), Keys());
  if (!of_box_.copies->busy()) ListAnew();
  Tell(progress.message, of_box_.copies->name(), progress.detail);
}

// As an installation a backup rests where it costs the face frames. A restore does not: somebody sets up a box and waits for it.
//
// The differences stand below the answers, and the list is open for as long as one that has just come.
void InstallService::StepCopies(Time now) {
  if (of_box_.copies->is_backup() && !MayWork()) return;
  const Progress progress = of_box_.copies->Step();
  if (of_box_.copies->busy()) {
    if (said_ && said_->message != progress.message) Tell(progress.message, of_box_.copies->name());
    return;
  }
  if (of_box_.copies->asks()) {
    menu_.Offer(BoxCopies::Answers(), 0, of_box_.copies->Differences());
    menu_.Open(now);
    is_open_ = menu_.IsOpen(now);
  } else {
    ListAnew();
  }
  Tell(progress.message, of_box_.copies->name(), progress.detail);
  menu_.ForgetPresses();
}

// The list is about the stick from now on.
void InstallService::DropQuestion() {
  if (of_box_.copies != nullptr && of_box_.copies->asks()) static_cast<void>(of_box_.copies->Answer(false));
  if (of_box_.settings != nullptr) static_cast<void>(of_box_.settings->Answer(false));
}

}  // namespace kaori::shows
