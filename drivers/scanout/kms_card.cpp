#include "drivers/scanout/kms_card.h"

#include <utility>

#include "drivers/base/fd_keeper.h"
#include "drivers/base/service.h"

namespace kaori::scanout {
namespace {

constexpr const char* kName = "card";  // In the manager's store, and at the holder.

struct Taken {
  UniqueFd file;
  bool kept = false;  // The service manager has it.
};

Result<Taken> TakeCard(const std::string& path, const std::string& holder) {
  if (auto kept = service::RetrieveFd(kName)) return Taken{std::move(*kept), true};
  auto opened = OpenCardFile(path.c_str());
  // Whoever opened the card first may show on it: that file is held, or another program has it.
  if (opened && !MayShow(opened->get())) opened = service::RetrieveFromKeeper(holder);
  if (!opened) return tl::unexpected(opened.error());
  return Taken{std::move(*opened)};
}

}  // namespace

Result<std::unique_ptr<KmsCard>> KmsCard::Open(const std::string& path, const std::string& holder) {
  auto taken = TakeCard(path, holder);
  if (!taken) return tl::unexpected(taken.error());
  if (auto ready = PrepareCardFile(taken->file.get()); !ready) return tl::unexpected(ready.error());
  auto draws = GbmDevice::Open(path.c_str(), taken->file.get());
  if (!draws) return tl::unexpected(draws.error());
  std::unique_ptr<KmsCard> card(new KmsCard(std::move(taken->file), std::move(*draws), holder));
  card->kept_ = taken->kept;
  return card;
}

Result<void> KmsCard::Hold() {
  if (!kept_)
    if (auto kept = service::StoreFd(shows_.get(), kName); !kept) return kept;
  kept_ = true;
  return service::GiveToKeeper(shows_.get(), holder_);
}

Result<std::unique_ptr<KmsScreen>> KmsCard::OpenScreen(const Clock& clock) {
  const auto make = [this](int width_px, int height_px) {
    return GbmWindow::Make(device(), shows_.get(), width_px, height_px);
  };
  return KmsScreen::Open(kernel_, make, clock, wishes_);
}

}  // namespace kaori::scanout
