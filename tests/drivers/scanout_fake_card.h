// A fake graphics card: a test plugs and pulls its screens, and calls for the vertical blank at which commits
// are carried out.
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

  // Each CRTC can drive each connector, and has one primary plane.
  FakeCard(int connector_count, int crtcs) : crtcs_(crtcs) {
    for (int i = 0; i < connector_count; ++i)
      connectors.push_back({kFirstConnector + std::uint32_t(i),
                            "HDMI-A-" + std::to_string(i + 1),
                            false,
                            (1U << crtcs) - 1,
                            {}});
  }

  // The test's side: cables, and what the card can do.
  std::vector<scanout::KmsConnector> connectors;
  void PlugIn(std::size_t connector, std::vector<drmModeModeInfo> modes = {ModeOf(640, 480)}) {
    connectors[connector].plugged = true;
    connectors[connector].modes = std::move(modes);
  }
  void Pull(std::size_t connector) { connectors[connector].plugged = false; }
  bool blind = false;           // It sees what is plugged in only when it is probed.
  bool hotplug = false;         // It reports that something changed.
  bool trains_no_link = false;  // Each link fails, and the card reports it.
  std::errc commit_fault{};     // Every commit fails with it, when set.
  int most_px = 1 << 20;        // What is wider is refused,
  int most_active = 32;         // and more screens than these at a time.

  // The vertical blank: what was committed is presented.
  void Blank(Time at) {
    for (const auto& [crtc, token] : std::exchange(pending_, {})) flips_.push_back({crtc, token, at});
  }
  // A flip of another program's commit.
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
  std::map<std::uint32_t, drmModeModeInfo> mode_blobs;
  std::map<std::uint32_t, std::vector<std::uint8_t>> dumb_buffers;  // By framebuffer.
  int test_commits = 0;
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
  bool DrainHotplug() override { return std::exchange(hotplug, false); }
  bool IsActive(std::uint32_t crtc) override { return Value(crtc, "ACTIVE") != 0; }
  scanout::Connection ConnectionOf(std::uint32_t connector) override {
    const bool plugged = blind ? seen_.contains(connector) : connectors[connector - kFirstConnector].plugged;
    return plugged ? scanout::Connection::kConnected : scanout::Connection::kDisconnected;
  }
  Result<scanout::KmsConnector> Probe(std::uint32_t connector) override {
    ++probes;
    const auto& found = connectors[connector - kFirstConnector];
    found.plugged ? void(seen_.insert(connector)) : void(seen_.erase(connector));
    return found;
  }
  Result<std::uint32_t> CreateModeBlob(const drmModeModeInfo& mode) override {
    mode_blobs[++last_mode_] = mode;
    return last_mode_;
  }
  void DestroyModeBlob(std::uint32_t blob) override { mode_blobs.erase(blob); }
  Result<void> Commit(std::span<const scanout::KmsSetting> settings, std::uint64_t token,
                      bool may_set_modes) override {
    if (commit_fault != std::errc()) return Fail(commit_fault, "show a picture");
    std::set<std::uint32_t> touched;
    for (const auto& [object, kind, property, value] : settings) {
      if (kind == DRM_MODE_OBJECT_PLANE && value != 0) touched.insert(object - kFirstPlane + kFirstCrtc);
      if (kind == DRM_MODE_OBJECT_CRTC) touched.insert(object);
    }
    if (std::ranges::any_of(touched, [&](auto crtc) { return pending_.contains(crtc); }))
      return Fail(std::errc::device_or_resource_busy, "show a picture");
    if (auto accepted = CheckLimits(settings); !accepted) return accepted;
    ++commits;
    modesets += may_set_modes ? 1 : 0;
    for (const std::uint32_t crtc : touched) pending_[crtc] = token;
    for (const auto& [object, kind, property, value] : settings) {
      state_[{object, property}] = value;
      if (std::string_view(property) == "link-status") TrainLink(object, may_set_modes);
    }
    return {};
  }
  Result<void> TestCommit(std::span<const scanout::KmsSetting> settings) override {
    ++test_commits;
    return CheckLimits(settings);
  }
  std::optional<scanout::KmsFlip> ReadFlip() override {
    if (flips_.empty()) return std::nullopt;
    const auto flip = flips_.front();
    flips_.pop_front();
    return flip;
  }
  std::vector<std::uint32_t> Framebuffers() override { return {framebuffers.begin(), framebuffers.end()}; }
  void RemoveFramebuffer(std::uint32_t framebuffer) override { framebuffers.erase(framebuffer); }
  std::uint32_t FramebufferOn(std::uint32_t plane) override { return std::uint32_t(Value(plane, "FB_ID")); }
  Result<scanout::KmsDumbBuffer> CreateDumbBuffer(int width_px, int height_px) override {
    const std::uint32_t framebuffer = ++last_dumb_buffer_;
    const std::size_t pitch_bytes = std::size_t(width_px) * 4 + kPadding_bytes;
    auto& bytes = dumb_buffers[framebuffer];
    bytes.resize(pitch_bytes * std::size_t(height_px));
    framebuffers.insert(framebuffer);
    return scanout::KmsDumbBuffer{framebuffer, pitch_bytes, bytes};
  }
  void UnmapDumbBuffer(const scanout::KmsDumbBuffer& buffer) override {
    dumb_buffers.erase(buffer.framebuffer);
  }

 private:
  // Without a mode that is set nothing is trained.
  void TrainLink(std::uint32_t connector, bool sets_mode) {
    const bool is_bad = trains_no_link || !sets_mode;
    connectors[connector - kFirstConnector].link_is_bad = is_bad;
    hotplug = hotplug || is_bad;
  }
  static constexpr std::size_t kPadding_bytes = 64;  // Behind each row, as cards add it.

  Result<void> CheckLimits(std::span<const scanout::KmsSetting> settings) const {
    int active = 0;
    for (const auto& [object, kind, property, value] : settings) {
      if (std::string_view(property) != "MODE_ID" || value == 0) continue;
      ++active;
      if (mode_blobs.at(std::uint32_t(value)).hdisplay > most_px) return FailInput("show a picture");
    }
    if (active > most_active) return Fail(std::errc::no_space_on_device, "show a picture");
    return {};
  }

  int crtcs_;
  std::set<std::uint32_t> seen_;  // Of a card that is blind.
  std::uint32_t last_mode_ = 0;
  std::uint32_t last_dumb_buffer_ = 5000;
  std::map<std::uint32_t, std::uint64_t> pending_;  // CRTCs, and the tokens of their commits.
  std::deque<scanout::KmsFlip> flips_;
};

// Two framebuffers that take turns.
class FakeSurface final : public scanout::KmsSurface {
 public:
  FakeSurface(FakeCard& card, std::uint32_t first) : card_(card), first_(first) {}
  // No EGL looks at it.
  gbm_surface* native() const override { return nullptr; }
  Result<std::uint32_t> LockFront() override {
    const std::uint32_t framebuffer = first_ + turn_++ % 2;
    card_.framebuffers.insert(framebuffer);
    return framebuffer;
  }
  void ReleasePrevious() override {}
  bool Owns(std::uint32_t framebuffer) const override {
    return framebuffer == first_ || framebuffer == first_ + 1;
  }

 private:
  FakeCard& card_;
  std::uint32_t first_;
  std::uint32_t turn_ = 0;
};

}  // namespace kaori::tests
