// A graphics card made of memory: screens are plugged and pulled by a test, commits are carried out at the
// blank that the test calls for.
#pragma once

#include <algorithm>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/scanout/kms_device.h"

namespace kaori::tests {

inline drmModeModeInfo ModeOf(int width_px, int height_px, std::uint32_t type = DRM_MODE_TYPE_PREFERRED) {
  drmModeModeInfo mode{};
  mode.hdisplay = std::uint16_t(width_px);
  mode.vdisplay = std::uint16_t(height_px);
  mode.type = type;
  return mode;
}

class FakeCard final : public scanout::KmsDevice {
 public:
  static constexpr std::uint32_t kFirstCrtc = 100, kFirstPlane = 200, kFirstConnector = 300;

  // A card with so many sockets and CRTCs; each CRTC can drive each socket, and has one primary plane.
  FakeCard(int sockets, int crtcs) : crtcs_(crtcs) {
    for (int i = 0; i < sockets; ++i)
      connectors.push_back({kFirstConnector + std::uint32_t(i),
                            "HDMI-A-" + std::to_string(i + 1),
                            false,
                            (1U << crtcs) - 1,
                            {}});
  }

  // The cables' side.
  std::vector<scanout::KmsConnector> connectors;
  void PlugIn(std::size_t socket, std::vector<drmModeModeInfo> modes = {ModeOf(640, 480)}) {
    connectors[socket].plugged = true;
    connectors[socket].modes = std::move(modes);
  }
  void Pull(std::size_t socket) { connectors[socket].plugged = false; }
  bool blind = false;        // It sees what is plugged in only when it is probed.
  bool stirred = false;      // It says that something changed.
  std::errc commit_fault{};  // Every commit fails with it, when set.
  int most_px = 1 << 20;     // What is wider is refused,
  int most_lit = 32;         // and more screens than these at a time.

  // The vertical blank: what was asked for comes to light.
  void Blank(Time at) {
    for (const auto& [crtc, token] : std::exchange(owing_, {})) flips_.push_back({crtc, token, at});
  }
  // A flip that nobody here asked for.
  void StrayFlip(std::uint32_t crtc, std::uint64_t token) { flips_.push_back({crtc, token, Time{}}); }

  // What a test may look at.
  std::uint64_t Value(std::uint32_t object, const std::string& property) const {
    const auto found = state_.find({object, property});
    return found == state_.end() ? 0 : found->second;
  }
  std::uint64_t Shows(std::size_t crtc) const { return Value(kFirstPlane + std::uint32_t(crtc), "FB_ID"); }
  int commits = 0;
  int modesets = 0;
  int probes = 0;
  std::set<std::uint32_t> framebuffers;  // Of the card's file.
  std::map<std::uint32_t, drmModeModeInfo> modes_told;
  std::map<std::uint32_t, std::vector<std::uint8_t>> sheets;  // By framebuffer.
  int tries = 0;
  std::map<std::pair<std::uint32_t, std::string>, std::uint64_t> state_;

  int pollable() const override { return -1; }
  std::vector<std::uint32_t> Connectors() override {
    std::vector<std::uint32_t> ids;
    for (const auto& connector : connectors) ids.push_back(connector.id);
    return ids;
  }
  std::vector<std::uint32_t> Crtcs() override {
    std::vector<std::uint32_t> ids;
    for (int i = 0; i < crtcs_; ++i) ids.push_back(kFirstCrtc + std::uint32_t(i));
    return ids;
  }
  std::vector<scanout::KmsPlane> PrimaryPlanes() override {
    std::vector<scanout::KmsPlane> planes;
    for (int i = 0; i < crtcs_; ++i) planes.push_back({kFirstPlane + std::uint32_t(i), 1U << i});
    return planes;
  }
  bool Stirred() override { return std::exchange(stirred, false); }
  bool IsLit(std::uint32_t crtc) override { return Value(crtc, "ACTIVE") != 0; }
  scanout::Plug PlugOf(std::uint32_t connector) override {
    const bool plugged = blind ? seen_.contains(connector) : connectors[connector - kFirstConnector].plugged;
    return plugged ? scanout::Plug::kPlugged : scanout::Plug::kEmpty;
  }
  Result<scanout::KmsConnector> Probe(std::uint32_t connector) override {
    ++probes;
    const auto& found = connectors[connector - kFirstConnector];
    found.plugged ? void(seen_.insert(connector)) : void(seen_.erase(connector));
    return found;
  }
  Result<std::uint32_t> TellMode(const drmModeModeInfo& mode) override {
    modes_told[++last_mode_] = mode;
    return last_mode_;
  }
  void ForgetMode(std::uint32_t blob) override { modes_told.erase(blob); }
  Result<void> Commit(std::span<const scanout::KmsSetting> settings, std::uint64_t token,
                      bool may_set_modes) override {
    if (commit_fault != std::errc()) return Fail(commit_fault, "show a picture");
    std::set<std::uint32_t> touched;
    for (const auto& [object, kind, property, value] : settings) {
      if (kind == DRM_MODE_OBJECT_PLANE && value != 0) touched.insert(object - kFirstPlane + kFirstCrtc);
      if (kind == DRM_MODE_OBJECT_CRTC) touched.insert(object);
    }
    if (std::ranges::any_of(touched, [&](auto crtc) { return owing_.contains(crtc); }))
      return Fail(std::errc::device_or_resource_busy, "show a picture");
    if (auto taken = Weigh(settings); !taken) return taken;
    ++commits;
    modesets += may_set_modes ? 1 : 0;
    for (const std::uint32_t crtc : touched) owing_[crtc] = token;
    for (const auto& [object, kind, property, value] : settings) state_[{object, property}] = value;
    return {};
  }
  Result<void> Try(std::span<const scanout::KmsSetting> settings) override {
    ++tries;
    return Weigh(settings);
  }
  std::optional<scanout::KmsFlip> ReadFlip() override {
    if (flips_.empty()) return std::nullopt;
    const auto flip = flips_.front();
    flips_.pop_front();
    return flip;
  }
  std::vector<std::uint32_t> Framebuffers() override { return {framebuffers.begin(), framebuffers.end()}; }
  void Remove(std::uint32_t framebuffer) override { framebuffers.erase(framebuffer); }
  std::uint32_t PictureOn(std::uint32_t plane) override { return std::uint32_t(Value(plane, "FB_ID")); }
  Result<scanout::KmsSheet> MakeSheet(int width_px, int height_px) override {
    const std::uint32_t framebuffer = ++last_sheet_;
    const std::size_t pitch_bytes = std::size_t(width_px) * 4 + kOdd_bytes;
    auto& bytes = sheets[framebuffer];
    bytes.resize(pitch_bytes * std::size_t(height_px));
    framebuffers.insert(framebuffer);
    return scanout::KmsSheet{framebuffer, pitch_bytes, bytes};
  }
  void ForgetSheet(const scanout::KmsSheet& sheet) override { sheets.erase(sheet.framebuffer); }

 private:
  static constexpr std::size_t kOdd_bytes = 64;  // What a card adds to a row.

  Result<void> Weigh(std::span<const scanout::KmsSetting> settings) const {
    int lit = 0;
    for (const auto& [object, kind, property, value] : settings) {
      if (std::string_view(property) != "MODE_ID" || value == 0) continue;
      ++lit;
      if (modes_told.at(std::uint32_t(value)).hdisplay > most_px)
        return FailInput("show a picture");
    }
    if (lit > most_lit) return Fail(std::errc::no_space_on_device, "show a picture");
    return {};
  }

  int crtcs_;
  std::set<std::uint32_t> seen_;  // By a card that is blind.
  std::uint32_t last_mode_ = 0;
  std::uint32_t last_sheet_ = 5000;
  std::map<std::uint32_t, std::uint64_t> owing_;  // CRTCs, and the tokens of their commits.
  std::deque<scanout::KmsFlip> flips_;
};

// Two pictures that take turns.
class FakePictures final : public scanout::KmsPictures {
 public:
  FakePictures(FakeCard& card, std::uint32_t first) : card_(card), first_(first) {}
  void* window() const override { return const_cast<FakePictures*>(this); }
  Result<std::uint32_t> LockFront() override {
    const std::uint32_t framebuffer = first_ + turn_++ % 2;
    card_.framebuffers.insert(framebuffer);
    return framebuffer;
  }
  void ReleasePrevious() override {}
  bool Made(std::uint32_t framebuffer) const override {
    return framebuffer == first_ || framebuffer == first_ + 1;
  }

 private:
  FakeCard& card_;
  std::uint32_t first_;
  std::uint32_t turn_ = 0;
};

}  // namespace kaori::tests
