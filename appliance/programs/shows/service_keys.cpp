// The part of InstallService that has to do with the keys of whoever signs shows.
#include <string>

#include "appliance/programs/shows/install_service.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

// Spaces stand in fingerprints for people's eyes only.
std::string KeyName(const show::PublicKey& key) {
  std::string name = show::Fingerprint(key);
  std::erase(name, ' ');
  return name + ".pub";
}

}  // namespace

// A press beside the one that was meant must not have somebody unknown play here for ever. The answers carry the key, so that what is
// agreed to is what was shown, whatever the stick says later; the first one leaves all as it is.
void InstallService::AskForKey(const Choosable& taken) {
  const auto answer = [&taken](Choosable::Kind kind, const char* words) {
    return Choosable{.kind = kind,
                     .offer = {.file = {}, .name = words},
                     .remark = {},
                     .key = taken.key,
                     .id = taken.offer.name};
  };
  menu_.Offer({answer(Choosable::Kind::kDistrust, "leave this key out"),
               answer(Choosable::Kind::kTrust, "yes, trust this key")},
              0, {"key " + taken.offer.name + "  " + taken.remark});
  Tell(Message::kAskKey, taken.offer.name);
}

// The list of the stick comes back in each case, with the numbers that it had.
void InstallService::AnswerForKey(const Choosable& taken) {
  const bool is_trusted = taken.kind == Choosable::Kind::kTrust;
  const auto kept = is_trusted ? KeepKey(taken.key) : Result<void>{};
  ListAnew();
  if (!kept) return Tell(DiskMessageOf(kept.error()), taken.id, kept.error().message());
  if (!is_trusted) return Tell(Message::kLeft);
  Tell(Message::kKeyTaken, taken.id, show::Fingerprint(taken.key));
}

// The key alone, under a name that no stick chooses.
Result<void> InstallService::KeepKey(const show::PublicKey& key) const {
  std::error_code none;
  std::filesystem::create_directories(places_.keys, none);
  const std::string line = show::PublicKeyLine(key);
  return WriteWholeFile(places_.keys / KeyName(key), {AsBytes(line)});
}

}  // namespace kaori::shows
