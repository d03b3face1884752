#include "drivers/scanout/kms_card.h"

#include <utility>

#include "drivers/base/fd_keeper.h"
#include "drivers/base/service.h"

namespace kaori::scanout {
namespace {

// The name of the card's file in the service manager's fd store.
constexpr const char* kName = "card";

// The card's file, and whether the service manager has a copy.
struct CardFile {
  UniqueFd file;
  bool kept = false;  // The service manager has it.
};

// A copy that was kept is still DRM master and has the last picture on it: it comes first.
Result<CardFile> AcquireCardFile(const std::string& path, const std::string& fd_keeper) {
  if (auto kept = service::RetrieveFd(kName)) return CardFile{std::move(*kept), true};
  auto opened = OpenCardFile(path.c_str());
  // Another file is the card's master already: the fd keeper holds it, or another program has it.
  if (opened && !IsMaster(opened->get())) {
    opened = service::RetrieveFromKeeper(fd_keeper);
    if (!opened)
      return Fail(opened.error().cause,
                  "take over " + path + " from the program that shows its picture on it");
  }
  if (!opened) return tl::unexpected(opened.error());
  return CardFile{std::move(*opened)};
}

}  // namespace

Result<std::unique_ptr<KmsCard>> KmsCard::Open(const std::string& path, const std::string& fd_keeper) {
  auto acquired = AcquireCardFile(path, fd_keeper);
  if (!acquired) return tl::unexpected(acquired.error());
  if (auto ready = PrepareCardFile(acquired->file.get()); !ready) return tl::unexpected(ready.error());
  auto draws = GbmDevice::Open(path.c_str(), acquired->file.get());
  if (!draws) return tl::unexpected(draws.error());
  std::unique_ptr<KmsCard> card(new KmsCard(std::move(acquired->file), std::move(*draws), fd_keeper));
  card->kept_ = acquired->kept;
  return card;
}

Result<void> KmsCard::Preserve() {
  if (!kept_)
    if (auto kept = service::StoreFd(shows_.get(), kName); !kept) return kept;
  kept_ = true;
  return service::GiveToKeeper(shows_.get(), fd_keeper_);
}

Result<std::unique_ptr<KmsScreen>> KmsCard::OpenScreen(const Clock& clock) {
  const auto make = [this](int width_px, int height_px) {
    return GbmSurface::Make(device(), shows_.get(), width_px, height_px);
  };
  return KmsScreen::Open(kernel_, make, clock, preferences_);
}

}  // namespace kaori::scanout
