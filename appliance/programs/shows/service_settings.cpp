// The part of InstallService that has to do with the box's settings.
#include "appliance/programs/shows/install_service.h"

namespace kaori::shows {

bool InstallService::IsOfSettings(const Choosable& taken) const {
  switch (taken.kind) {
    case Choosable::Kind::kSettings:
    case Choosable::Kind::kSetting:
    case Choosable::Kind::kValue:
    case Choosable::Kind::kSettingsFile:
    case Choosable::Kind::kSettingsBefore:
      return true;
    case Choosable::Kind::kNo:
    case Choosable::Kind::kYes:
      return of_box_.copies == nullptr || !of_box_.copies->asks();  // Else it answers what a restore asks.
    default:
      return false;
  }
}

// Each list takes the place of the one before it; the list of shows comes back at the end of all.
void InstallService::AcceptSettings(const Choosable& taken) {
  BoxSettings& settings = *of_box_.settings;
  if (taken.kind == Choosable::Kind::kSettings) {
    menu_.Offer(settings.Settings());
    return Tell(Message::kChooseSetting);
  }
  if (taken.kind == Choosable::Kind::kSetting) {
    menu_.Offer(settings.Values(taken.id));
    return Tell(Message::kChooseValue, taken.offer.name);
  }
  // All that is no answer begins something: a value of a setting, a file of the stick, or the way back.
  const bool answers = taken.kind == Choosable::Kind::kYes || taken.kind == Choosable::Kind::kNo;
  const Progress progress =
      answers ? settings.Answer(taken.kind == Choosable::Kind::kYes) : settings.Begin(taken);
  TellOfSettings(progress, answers && taken.kind == Choosable::Kind::kNo);
}

// The answers begin at line 0, and the differences stand beside them.
void InstallService::TellOfSettings(const Progress& progress, bool is_left) {
  const BoxSettings& settings = *of_box_.settings;
  if (settings.asks())
    menu_.Offer(BoxSettings::Answers(), 0, settings.Differences());
  else
    ListAnew();
  Tell(progress.message, is_left ? "" : settings.name(), progress.detail);
}

}  // namespace kaori::shows
