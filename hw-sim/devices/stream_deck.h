// A simulated Elgato Stream Deck: keys with pictures, by the bytes of its maker's published description.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "hw-sim/devices/hid_device.h"

namespace kaori::sim {

// What a person sees on a key: upright, 8-bit R, G, B, the upper left point first, without padding.
struct KeyPicture {
  int side_px = 0;  // Keys are square.
  std::vector<std::uint8_t> rgb;

  // The mean of all three colours over the whole key, 0 black .. 255 white.
  double brightness() const;
};

// Decodes the pictures that it is sent, as the real one does, so that what a host sends is proved to be a picture
// of the right size that stands upright. It shares no code with the box. One thread.
class StreamDeck final : public HidDevice {
 public:
  // kMini takes bitmaps, the others JPEG; kPlus has dials and a touch screen besides its keys, which tell of
  // themselves in reports of the same number.
  enum class Kind : std::uint8_t { kMk2, kXl, kPlus, kMini };
  static constexpr int kMostKeys = 32;  // Of the largest, the XL.

  explicit StreamDeck(Kind kind) : kind_(kind) {}

  // Test's side. Keys are counted from 0, the upper left one; those that it has not do nothing.
  int keys() const;
  void Push(int key) { Set(key, true); }
  void Release(int key) { Set(key, false); }
  void TurnDial(int dial, int clicks);     // Of the four of a kPlus; clockwise is positive.
  void TearNext() { tears_next_ = true; }  // The next report is cut short on its way.
  // Nothing: no picture was put on it since power came, or not all of one.
  const std::optional<KeyPicture>& picture(int key) const { return shown_.at(static_cast<std::size_t>(key)); }
  int pictures() const { return pictures_; }              // That were shown since it was made.
  int wrong_pages() const { return wrong_pages_; }        // Output reports that make no sense.
  int wrong_pictures() const { return wrong_pictures_; }  // Whole ones that are no picture for a key.

  // Appliance's side, as HidDevice says.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override;
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t> report) override;
  void HostCame() override {}
  void HostLeft() override {}
  // It shows no pictures without power.
  void PowerCycle() override;

 private:
  // Of the picture that comes for a key, page by page.
  struct Coming {
    std::vector<std::uint8_t> bytes;
    std::uint32_t pages = 0;
  };
  // One page of a picture, taken out of an output report.
  struct Page {
    std::size_t key = 0;
    std::uint32_t number = 0;
    bool is_last = false;
    std::span<const std::uint8_t> bytes;
  };
  void Set(int key, bool down);
  void Say(Report report);
  // Nothing: it is no page.
  std::optional<Page> PageOf(std::span<const std::uint8_t> report) const;

  Kind kind_;
  std::deque<Report> waiting_;
  std::uint32_t down_ = 0;  // Bit n: key n.
  bool tears_next_ = false;
  std::array<Coming, kMostKeys> coming_{};
  std::array<std::optional<KeyPicture>, kMostKeys> shown_{};
  int pictures_ = 0;
  int wrong_pages_ = 0;
  int wrong_pictures_ = 0;
};

}  // namespace kaori::sim
