#include "drivers/audio/sound_choice.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <optional>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::audio {
namespace {

// Often enough for somebody who plugs a microphone in before a show,
// seldom enough that the listing costs nothing.
constexpr Duration kCheckPeriod = std::chrono::seconds(2);
// A device that is busy, or that may not be opened yet, is waited for; another one is used after this time.
constexpr Duration kLongestRefusal = std::chrono::seconds(2);

// A device that was the nearest one when it was opened; it fails once another one is.
// Every other call goes to the device that it wraps.
class NearestPcm final : public AlsaPcm {
 public:
  NearestPcm(std::unique_ptr<AlsaPcm> pcm, std::string name, const Clock& clock,
             std::function<std::string()> nearest)
      : pcm_(std::move(pcm)),
        name_(std::move(name)),
        clock_(clock),
        nearest_(std::move(nearest)),
        check_at_(clock.now() + kCheckPeriod) {}

  ports::SoundFormat format() const override { return pcm_->format(); }
  int pollable() const override { return pcm_->pollable(); }
  int Start() override { return pcm_->Start(); }
  int Prepare() override { return pcm_->Prepare(); }
  int Resume() override { return pcm_->Resume(); }
  int Status(PcmStatus& into) override { return pcm_->Status(into); }
  long Read(std::span<std::int16_t> into) override { return IsNearest() ? pcm_->Read(into) : -ENODEV; }
  long Write(std::span<const std::int16_t> from) override {
    return IsNearest() ? pcm_->Write(from) : -ENODEV;
  }

 private:
  // Lists devices every kCheckPeriod only: it opens every card.
  bool IsNearest() {
    if (clock_.now() < check_at_) return true;
    check_at_ = clock_.now() + kCheckPeriod;
    return nearest_() == name_;
  }

  std::unique_ptr<AlsaPcm> pcm_;
  std::string name_;
  const Clock& clock_;
  std::function<std::string()> nearest_;
  Time check_at_;
};

// The device that is used, and those that refused: shared by an opener and the devices that it opens.
class SoundChoice : public std::enable_shared_from_this<SoundChoice> {
 public:
  SoundChoice(const Clock& clock, SoundSearch search) : clock_(clock), search_(std::move(search)) {}

  Result<std::unique_ptr<AlsaPcm>> OpenNamed(const std::string& name, Direction direction,
                                             const AlsaPreferences& preferences) const {
    return search_.open(name, direction, preferences);
  }

  // Opens the nearest device that lets itself be opened. Errors: the nearest one's, and no_such_device.
  Result<std::unique_ptr<AlsaPcm>> OpenNearest(Direction direction, const AlsaPreferences& preferences);

 private:
  struct Refusals {
    std::vector<std::string> listed;   // All devices at that time,
    std::vector<std::string> refused;  // and those of them that refused.
    // One that may open soon, and since when it is waited for.
    std::string awaited;
    Time awaited_since{};
  };

  // The devices that have not refused. Where other devices are there than before, all are asked again.
  std::vector<SoundDevice> Candidates(Direction direction);
  // Whether the device may open soon, so that no other one is taken in its place yet.
  bool IsAwaited(Refusals& refusals, const std::string& name, std::errc cause) const;
  Refusals& Of(Direction direction) { return direction == Direction::kCapture ? capture_ : playback_; }

  const Clock& clock_;
  SoundSearch search_;
  Refusals capture_, playback_;
};

std::vector<SoundDevice> SoundChoice::Candidates(Direction direction) {
  auto devices = search_.list(direction);
  std::vector<std::string> names;
  for (const SoundDevice& device : devices) names.push_back(device.name);
  Refusals& refusals = Of(direction);
  if (names != refusals.listed) refusals = {.listed = std::move(names), .refused = {}, .awaited = {}};
  std::erase_if(devices, [&](const SoundDevice& device) {
    return std::ranges::find(refusals.refused, device.name) != refusals.refused.end();
  });
  return devices;
}

// udev gives a card's files their group one after the other, and a program that ends has its device for a moment.
bool SoundChoice::IsAwaited(Refusals& refusals, const std::string& name, std::errc cause) const {
  if (cause != std::errc::permission_denied && cause != std::errc::device_or_resource_busy) return false;
  if (std::exchange(refusals.awaited, name) != name) refusals.awaited_since = clock_.now();
  return clock_.now() - refusals.awaited_since < kLongestRefusal;
}

// Where all refuse, all are asked again the next time.
Result<std::unique_ptr<AlsaPcm>> SoundChoice::OpenNearest(Direction direction,
                                                          const AlsaPreferences& preferences) {
  const char* const kind = direction == Direction::kCapture ? "microphone" : "loudspeaker";
  Refusals& refusals = Of(direction);
  std::optional<Error> refusal;
  for (auto devices = Candidates(direction); !devices.empty();) {
    const std::string name = Nearest(devices);
    search_.make_audible(name, direction);
    auto pcm = search_.open(name, direction, preferences);
    if (pcm) {
      refusals.awaited.clear();
      Log("{}: {} is the nearest{}", kind, name,
          refusal ? fmt::format(" that opens: {}", refusal->message()) : "");
      return std::make_unique<NearestPcm>(
          std::move(*pcm), name, clock_,
          [self = shared_from_this(), direction] { return Nearest(self->Candidates(direction)); });
    }
    if (!refusal) refusal = pcm.error();
    if (IsAwaited(refusals, name, pcm.error().cause)) return tl::unexpected(*refusal);
    refusals.refused.push_back(name);
    std::erase_if(devices, [&](const SoundDevice& device) { return device.name == name; });
  }
  refusals.refused.clear();
  if (refusal) return tl::unexpected(*refusal);
  return Fail(std::errc::no_such_device, std::string("find a ") + kind);
}

}  // namespace

// USB before all, since it was plugged in by somebody; then what is not at the end of a screen's cable; then
// whatever is there. Empty: nothing is.
std::string Nearest(std::span<const SoundDevice> devices) {
  for (const auto& wanted : {+[](const SoundDevice& d) { return d.usb; },
                             +[](const SoundDevice& d) { return !d.on_screen_cable; }}) {
    const auto found = std::ranges::find_if(devices, wanted);
    if (found != devices.end()) return found->name;
  }
  return devices.empty() ? std::string() : devices.front().name;
}

PcmOpener ChoosingPcmOpener(const Clock& clock, SoundSearch search) {
  return [choice = std::make_shared<SoundChoice>(clock, std::move(search))](
             const std::string& name, Direction direction, const AlsaPreferences& preferences) {
    return name == kAnySound ? choice->OpenNearest(direction, preferences)
                             : choice->OpenNamed(name, direction, preferences);
  };
}

}  // namespace kaori::audio
