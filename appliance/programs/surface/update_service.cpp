#include "appliance/programs/surface/update_service.h"

#include <algorithm>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::surface_update {
namespace {

// A look opens every surface that is plugged in and asks it for its version.
constexpr Duration kLookEvery = std::chrono::seconds(1);

}  // namespace

// The first surface that may have its update gets it, and the others come at later looks. A refusal is logged
// when its words change, and not at each look.
void UpdateService::Step(Circumstances box, Time now) {
  if (update_) return Go(now);
  if (!box.in_service || now < next_look_) return;
  next_look_ = now + kLookEvery;
  const auto dues = Look(box.dial_boxes);
  for (const Due& due : dues) {
    const auto may = MayUpdate(due.file->image, box);
    if (may) return Begin(due);
    const std::string refusal = due.port + ": " + may.error().message();
    if (std::exchange(refusal_, refusal) != refusal) LogWarning("the surface at {}", refusal);
  }
}

// The update borrows the file for as long as it runs: files_ never changes.
void UpdateService::Begin(const Due& due) {
  refusal_.clear();
  chip_ = due.chip;
  version_ = due.file->image.version;
  Log("the surface at {} has version {}, and gets version {}", due.port, VersionWords(due.version),
      VersionWords(version_));
  update_.emplace(bus_, due.port, *due.file);
}

// What failed is remembered by the chip and not by the port, so that a surface which is plugged in elsewhere
// is known.
void UpdateService::Go(Time now) {
  update_->Step(now);
  const bool is_done = update_->state() == SurfaceUpdate::State::kDone;
  if (!is_done && update_->state() != SurfaceUpdate::State::kFailed) return;
  if (is_done) {
    Log("{}", update_->outcome());
  } else {
    LogWarning("{}", update_->outcome());
    failed_.insert({chip_, version_});
  }
  update_.reset();
  next_look_ = now + kLookEvery;
}

// A device that is no surface of ours is opened once; what comes to its port later is another one.
std::vector<UpdateService::Due> UpdateService::Look(int& dial_boxes) {
  std::vector<Due> dues;
  dial_boxes = 0;
  const auto ports = bus_.Ports();
  if (!ports) return dues;
  std::erase_if(others_,
                [&](const std::string& port) { return std::ranges::find(*ports, port) == ports->end(); });
  for (const std::string& port : *ports) {
    if (others_.contains(port)) continue;
    const auto channel = bus_.Open(port);
    if (!channel) continue;
    const std::uint32_t product = ProductOf((*channel)->identity());
    if (product != kDialBoxImage && product != kStickPodImage) {
      others_.insert(port);
      continue;
    }
    const auto status = ReadStatus(**channel);
    dial_boxes += IsPlayingDialBox((*channel)->identity(), status) ? 1 : 0;
    if (!status) continue;
    if (auto due = DueAt((*channel)->identity(), *status)) dues.push_back(std::move(*due));
  }
  return dues;
}

// Due is what is older than the newest file, and what tries that very version without a confirmation. A
// surface that is newer than all files keeps what it has, and one that refuses for its chip's sake takes nothing.
// What it says was asked for by Look, once for this and for the count of dial boxes.
std::optional<UpdateService::Due> UpdateService::DueAt(const ports::HidIdentity& identity,
                                                       const wire::SurfaceStatus& status) const {
  const UpdateFile* const file = NewestFor(ProductOf(identity));
  if (file == nullptr || status.state == wire::SurfaceState::kRefuses) return std::nullopt;
  if (failed_.contains({status.chip_id, file->image.version})) return std::nullopt;
  const std::uint32_t version = VersionOf(status);
  const bool is_older = version < file->image.version;
  const bool is_tried = version == file->image.version && status.state == wire::SurfaceState::kTries;
  if (!is_older && !is_tried) return std::nullopt;
  return Due{.port = identity.port, .chip = status.chip_id, .version = version, .file = file};
}

// A folder may hold several updates for one product.
const UpdateFile* UpdateService::NewestFor(std::uint32_t product) const {
  const UpdateFile* newest = nullptr;
  for (const UpdateFile& file : files_)
    if (file.image.product == product && (newest == nullptr || file.image.version > newest->image.version))
      newest = &file;
  return newest;
}

}  // namespace kaori::surface_update
