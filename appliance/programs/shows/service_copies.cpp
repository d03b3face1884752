// The part of InstallService that has to do with backups and restores.
#include "appliance/programs/shows/install_service.h"
#include "appliance/programs/shows/offers.h"

namespace kaori::shows {

std::vector<Choosable> InstallService::WaysBackOnBox(bool has_stick) const {
  std::vector<Choosable> ways = WaysBack(folder_);
  if (copies_ == nullptr) return ways;
  for (Choosable& each : copies_->Offers(has_stick)) ways.push_back(std::move(each));
  return ways;
}

// A backup needs a stick; what a restore took away does not.
void InstallService::AcceptCopy(const Choosable& taken) {
  const bool answers = taken.kind == Choosable::Kind::kYes || taken.kind == Choosable::Kind::kNo;
  const Progress progress = answers ? copies_->Answer(taken.kind == Choosable::Kind::kYes)
                                    : copies_->Begin(taken, stick_.value_or(std::filesystem::path()), Keys());
  if (!copies_->busy()) ListAnew();
  Tell(progress.message, copies_->name(), progress.detail);
}

// The differences stand below the answers, and the list is open for as long as one that has just come.
void InstallService::StepCopies(Time now) {
  const Progress progress = copies_->Step();
  if (copies_->busy()) {
    if (said_ && said_->message != progress.message) Tell(progress.message, copies_->name());
    return;
  }
  if (copies_->asks()) {
    menu_.Offer(BoxCopies::Answers(), 0, copies_->Differences());
    menu_.Open(now);
    is_open_ = menu_.IsOpen(now);
  } else {
    ListAnew();
  }
  Tell(progress.message, copies_->name(), progress.detail);
  menu_.ForgetPresses();
}

// Nobody can answer any more: another stick is in, or none, and the list is about that.
void InstallService::DropQuestion() {
  if (copies_ != nullptr && copies_->asks()) static_cast<void>(copies_->Answer(false));
}

}  // namespace kaori::shows
