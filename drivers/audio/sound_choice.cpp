#include "drivers/audio/sound_choice.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "drivers/base/log.h"

namespace kaori::audio {
namespace {

// Often enough for somebody who plugs a microphone in before a show,
// seldom enough that the listing costs nothing.
constexpr Duration kCheckPeriod = std::chrono::seconds(2);

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

Result<std::unique_ptr<AlsaPcm>> OpenNearest(const SoundSearch& search, Direction direction,
                                             const AlsaPreferences& preferences, const Clock& clock) {
  const auto nearest = [list = search.list, direction] { return Nearest(list(direction)); };
  const std::string name = nearest();
  const char* const kind = direction == Direction::kCapture ? "microphone" : "loudspeaker";
  if (name.empty()) return Fail(std::errc::no_such_device, std::string("find a ") + kind);
  search.make_audible(name, direction);
  auto pcm = search.open(name, direction, preferences);
  if (!pcm) return pcm;
  Log("{}: {} is the nearest", kind, name);
  return std::make_unique<NearestPcm>(std::move(*pcm), name, clock, nearest);
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
  return [&clock, search = std::move(search)](const std::string& name, Direction direction,
                                              const AlsaPreferences& preferences) {
    return name == kAnySound ? OpenNearest(search, direction, preferences, clock)
                             : search.open(name, direction, preferences);
  };
}

}  // namespace kaori::audio
