#include "tests/hw-sim/console_toy_stage.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "drivers/audio/local_loudspeaker.h"
#include "drivers/hid/local_bus.h"
#include "drivers/scanout/local_screen.h"
#include "firmware/wire/dial_box.h"

namespace kaori::console {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr int kHandLength_px = 50;
constexpr std::uint8_t kSpace = 0x2C;

void Say(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

// A device that nothing here can read stays open, and unread.
bool Refuse(const Error& error) {
  Say(error.message());
  return true;
}

bool held(const decode::KeySample& sample, std::uint8_t usage) {
  return ((sample.keys.down[usage / 32] >> (usage % 32)) & 1u) != 0;
}

// Soft waves with a fine grain: about as hard to encode as a face.
std::vector<std::uint8_t> Backdrop(int width_px, int height_px) {
  std::vector<std::uint8_t> pixels;
  std::uint32_t grain = 1;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      grain = grain * 1664525u + 1013904223u;
      const double wave = std::sin(x * 0.013) * std::cos(y * 0.017) + std::sin((x + y) * 0.041) * 0.3;
      const auto level = static_cast<std::uint8_t>(60 + 30 * wave + (grain >> 29));
      pixels.insert(pixels.end(), {level, static_cast<std::uint8_t>(level * 3 / 4), level, 255});
    }
  }
  return pixels;
}

// Six yellow pixels square, about (x_px, y_px).
void DrawDot(const ports::PixelBuffer& into, int x_px, int y_px) {
  for (int y = y_px - 3; y < y_px + 3; ++y) {
    for (int x = x_px - 3; x < x_px + 3; ++x) {
      const auto at = static_cast<std::size_t>(y * into.width_px + x) * 4;
      into.memory()[at] = into.memory()[at + 1] = 255;
      into.memory()[at + 2] = 0;
    }
  }
}

// Every report that waits goes to `handle`. False once the device has gone.
template <class Handler>
bool ReadAll(ports::HidChannel& channel, Handler handle) {
  std::array<std::uint8_t, 64> report{};
  auto input = channel.Read(report);
  for (; input; input = channel.Read(report)) handle(std::span(report).first(input->bytes), input->at);
  return input.error().cause == std::errc::resource_unavailable_try_again;
}

}  // namespace

ToyStage::ToyStage(std::string folder, std::unique_ptr<ports::HidBus> bus)
    : folder_(std::move(folder)), bus_(std::move(bus)) {}

Result<std::unique_ptr<ToyStage>> ToyStage::Open(const std::string& folder) {
  auto bus = hid::LocalHidBus::Watch(folder);
  if (!bus) return tl::unexpected(bus.error());
  return std::unique_ptr<ToyStage>(new ToyStage(folder, std::move(*bus)));
}

void ToyStage::Step() {
  OpenPorts();
  std::erase_if(channels_, [this](const auto& open) { return !Read(open.first, *open.second); });
  ReadLines();
  Sound();
  Draw();
}

void ToyStage::OpenPorts() {
  const auto ports = bus_->Ports();
  if (!ports) return;
  for (const auto& port : *ports) {
    if (channels_.contains(port)) continue;
    if (auto channel = bus_->Open(port)) channels_[port] = std::move(*channel);
  }
}

// A cable that was out and in again between two steps has left a channel that ends here; the next step opens another.
bool ToyStage::Read(const std::string& port, ports::HidChannel& channel) {
  if (port == "dial-box") return ReadDialBox(channel);
  if (port.starts_with("stick-")) return ReadStick(channel);
  if (port == "keyboard") return ReadKeyboard(channel);
  if (port == "pointer") return ReadPointer(channel);
  return true;
}

bool ToyStage::ReadDialBox(ports::HidChannel& channel) {
  if (!dial_box_) {
    auto decoder = decode::DialBoxDecoder::For(channel.identity());
    if (!decoder) return Refuse(decoder.error());
    dial_box_.emplace(std::move(*decoder));
  }
  return ReadAll(channel, [&](auto report, Time at) {
    const decode::DialSample before = dial_box_->sample();
    if (const auto now = dial_box_->Decode(report, at)) TellDialBox(before, *now, channel);
  });
}

void ToyStage::TellDialBox(const decode::DialSample& before, const decode::DialSample& now,
                           ports::HidChannel& channel) {
  for (std::size_t n = 0; n < now.counts.size(); ++n)
    if (now.counts[n] != before.counts[n]) Say(fmt::format("dial {} {}", n + 1, now.counts[n]));
  const std::uint32_t changed = now.buttons.down[0] ^ before.buttons.down[0];
  for (unsigned n = 0; n < 32; ++n)
    if (((changed >> n) & 1u) != 0) Say(fmt::format("button {} {}", n + 1, (now.buttons.down[0] >> n) & 1u));
  lamps_ ^= now.buttons.down[0] & changed;
  if (changed != 0) (void)channel.Write(dial_box_->LampReport(lamps_));
}

bool ToyStage::ReadStick(ports::HidChannel& channel) {
  const std::string& port = channel.identity().port;
  if (!sticks_.contains(port)) {
    auto decoder = decode::JoystickDecoder::For(channel.identity());
    if (!decoder) return Refuse(decoder.error());
    sticks_.emplace(port, std::move(*decoder));
  }
  return ReadAll(channel, [&](auto report, Time at) {
    if (const auto now = sticks_.at(port).Decode(report, at))
      Say(fmt::format("{} {:.2f} {:.2f} {:.2f} {:.2f}", port, now->x, now->y, now->twist, now->slider));
  });
}

bool ToyStage::ReadKeyboard(ports::HidChannel& channel) {
  if (!keyboard_) {
    auto decoder = decode::KeyboardDecoder::For(channel.identity());
    if (!decoder) return Refuse(decoder.error());
    keyboard_.emplace(std::move(*decoder));
  }
  return ReadAll(channel, [&](auto report, Time at) {
    const decode::KeySample before = keyboard_->sample();
    const auto now = keyboard_->Decode(report, at);
    for (unsigned usage = 4; now && usage < 232; ++usage) {
      const auto key = static_cast<std::uint8_t>(usage);
      if (held(*now, key) != held(before, key)) Say(fmt::format("key {} {}", usage, held(*now, key) ? 1 : 0));
    }
  });
}

bool ToyStage::ReadPointer(ports::HidChannel& channel) {
  if (!pointer_) {
    auto decoder = decode::PointerDecoder::For(channel.identity());
    if (!decoder) return Refuse(decoder.error());
    pointer_.emplace(std::move(*decoder));
  }
  return ReadAll(channel, [&](auto report, Time at) {
    if (const auto now = pointer_->Decode(report, at))
      Say(fmt::format("pointer {:.3f} {:.3f} {} {}", now->x, now->y, now->buttons.down[0], now->wheel));
  });
}

// The panel is in this program's own loop: it is connected in one step and greeted in a later one.
void ToyStage::ReadLines() {
  if (!lines_) {
    auto connected = gpio::LocalLines::Connect(folder_);
    if (!connected) return;
    lines_ = std::move(*connected);
    lines_greeted_ = false;
    return;
  }
  if (!lines_greeted_) {
    if (!lines_->Greet({})) return;
    lines_greeted_ = true;
    (void)lines_->Drive(0, true);
  }
  while (const auto edge = lines_->ReadEdge()) {
    Say(fmt::format("line {} {}", edge->line, edge->active ? 1 : 0));
    if (edge->line == 1) (void)lines_->Drive(0, !edge->active);
  }
}

// As much as the loudspeaker has room for.
void ToyStage::Sound() {
  if (!loudspeaker_) {
    auto opened = audio::LocalLoudspeaker::Open(folder_, clock_);
    if (!opened) return;
    loudspeaker_ = std::move(*opened);
  }
  std::array<std::int16_t, 2 * 480> block{};
  for (std::size_t frame = 0; frame < block.size() / 2; ++frame) {
    const double time_s = static_cast<double>(played_frames_ + frame) / 48000;
    block[2 * frame] = block[2 * frame + 1] =
        static_cast<std::int16_t>(8000 * std::sin(2 * kPi * 440 * time_s));
  }
  const auto played = loudspeaker_->Write(block);
  if (played) played_frames_ += played->frames;
  if (!played && played.error().cause == std::errc::no_such_device) loudspeaker_.reset();
}

// Eight clock hands, one for each dial; the space bar turns the light out.
void ToyStage::Draw() {
  if (!screen_) {
    auto screen = scanout::LocalScreen::Open(folder_);
    if (!screen) return;
    screen_ = std::move(*screen);
  }
  while (screen_->ReadFlip()) {
  }
  auto buffer = screen_->Acquire();
  if (!buffer) {
    if (buffer.error().cause == std::errc::no_such_device) screen_.reset();
    return;
  }
  if (backdrop_.size() != buffer->memory().size()) backdrop_ = Backdrop(buffer->width_px, buffer->height_px);
  const bool dark = keyboard_ && held(keyboard_->sample(), kSpace);
  if (dark)
    std::ranges::fill(buffer->memory(), std::uint8_t{0});
  else
    std::ranges::copy(backdrop_, buffer->memory().begin());
  for (std::size_t dial = 0; dial < wire::kDials; ++dial) DrawHand(*buffer, dial);
  (void)screen_->Present(++frame_);
}

void ToyStage::DrawHand(const ports::PixelBuffer& into, std::size_t dial) const {
  const double counts = dial_box_ ? dial_box_->sample().counts[dial] : 0;
  const double angle_rad = counts / wire::kDialCountsPerTurn * 2 * kPi;
  const double centre_x_px = into.width_px * (static_cast<double>(dial) + 0.5) / wire::kDials;
  for (int along_px = 0; along_px < kHandLength_px; along_px += 2) {
    const int x_px = static_cast<int>(centre_x_px + std::sin(angle_rad) * along_px);
    const int y_px = static_cast<int>(into.height_px / 2.0 + std::cos(angle_rad) * along_px);
    DrawDot(into, x_px, y_px);
  }
}

}  // namespace kaori::console
