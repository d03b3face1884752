#include "tests/appliance/programs/lips_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hw-sim/devices/picture_formats.h"

namespace kaori::lips {
namespace {

using ports::PixelFormat;

constexpr double kFramesPerSecond = 30;
constexpr int kRestFrames = 40;
constexpr int kRestPictures = 4;   // Drawn once and shown over and over.
constexpr float kBelieved = 0.3F;  // The quality from which the mouth follows the lips.
constexpr double kShut = 0.24;     // What is higher opens between the lips.
constexpr double kExposure_s = 0.5 / kFramesPerSecond;

double Wave(double time_s, double hz, double phase = 0) {
  return std::sin(2 * std::numbers::pi * (hz * time_s + phase));
}

// A mouth that talks without ever saying anything: every height meets every width.
sim::Mouth Talking(double time_s) {
  return {0.25 + 0.26 * (1 - std::cos(2 * std::numbers::pi * 2.3 * time_s)),
          0.95 + 0.28 * Wave(time_s, 1.37)};
}

class Shooting {
 public:
  explicit Shooting(const Condition& condition) : condition_(condition) {}

  sim::LipScene SceneAt(double time_s, std::uint32_t sequence) const {
    sim::LipScene scene;
    scene.camera.sequence = sequence;
    if (time_s > 0) scene.person.mouth = Talking(time_s);
    condition_.play(time_s, scene);
    return scene;
  }

  // The frame borrows until the next one.
  ports::CameraFrame Shoot(const sim::LipScene& scene) {
    const auto& format = condition_.format;
    const auto width = static_cast<std::size_t>(format.width_px);
    yuyv_.resize(width * static_cast<std::size_t>(format.height_px) * 2);
    sim::PaintScene(scene, {format.width_px, format.height_px, yuyv_});
    auto stride = static_cast<std::uint32_t>(width * 2);
    std::size_t used = yuyv_.size();
    bytes_ = yuyv_;
    if (format.pixels == PixelFormat::kNv12) {
      used = sim::YuyvToNv12(yuyv_, format.width_px, format.height_px, bytes_);
      stride = static_cast<std::uint32_t>(width);
    } else if (format.pixels == PixelFormat::kMjpeg) {
      used = sim::YuyvToJpeg(yuyv_, format.width_px, format.height_px, bytes_, condition_.jpeg_quality);
      stride = 0;
    }
    bytes_.resize(used);
    return {.at = {},
            .sequence = scene.camera.sequence,
            .format = format,
            .stride_bytes = stride,
            .bytes = bytes_};
  }

 private:
  const Condition& condition_;
  std::vector<std::uint8_t> yuyv_;
  std::vector<std::uint8_t> bytes_;
};

void ParseArguments(Shooting& shooting, LipMeter& meter, Time& at) {
  decode::PlaneReader reader;
  for (std::uint32_t picture = 0; picture < kRestPictures; ++picture) {
    const auto planes = reader.Read(shooting.Shoot(shooting.SceneAt(0, picture)));
    for (int n = 0; n < kRestFrames / kRestPictures; ++n) {
      at += FromSeconds(1 / kFramesPerSecond);
      meter.Measure(*planes, at);
    }
  }
}

Condition Make(std::string name, std::function<void(double, sim::LipScene&)> play,
               LipSettings settings = {}) {
  return {.name = std::move(name), .play = std::move(play), .settings = settings};
}

Condition In(ports::CameraFormat format, int jpeg_quality, Condition condition) {
  condition.format = format;
  condition.jpeg_quality = jpeg_quality;
  return condition;
}

LipSettings Painted(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  LipSettings settings;
  settings.paint = {red, green, blue};
  return settings;
}

LipSettings Marked() {
  LipSettings settings;
  settings.marker = true;
  return settings;
}

// A head that sways, nods and leans; `nearer` is how far it comes nearer and goes back.
sim::HeadPose Swaying(double time_s, double far, double lean_rad, double nearer) {
  if (time_s <= 0) return {};
  return {far * Wave(time_s, 0.45), 0.4 * far * Wave(time_s, 0.6), 1 + nearer * Wave(time_s, 0.4),
          lean_rad * Wave(time_s, 0.35)};
}

void Smear(double time_s, sim::LipScene& scene, double far) {
  scene.person.head = Swaying(time_s, far, 0.05, 0);
  if (time_s > kExposure_s) scene.head_before = Swaying(time_s - kExposure_s, far, 0.05, 0);
}

}  // namespace

std::vector<Condition> NormalSet() {
  using sim::LipScene;
  const auto plain = [](double, LipScene&) {};
  return {
      Make("a still head", plain),
      Make("dim light, more gain, more noise",
           [](double, LipScene& s) { s.light.level = 0.3, s.camera.gain = 1.5, s.camera.noise_steps = 4; }),
      Make("bright light", [](double, LipScene& s) { s.light.level = 1.4; }),
      Make("light that breathes", [](double t, LipScene& s) { s.light.level = 0.75 + 0.35 * Wave(t, 0.8); }),
      Make("a head that sways", [](double t, LipScene& s) { s.person.head = Swaying(t, 0.35, 0.17, 0.02); }),
      Make(
          "a marker: a head that comes nearer",
          [](double t, LipScene& s) {
            s.person.marker = true;
            s.person.head = Swaying(t, 0.3, 0.2, 0.12);
          },
          Marked()),
      Make("a head far away", [](double, LipScene& s) { s.person.head.scale = 0.55; }),
      Make(
          "green paint",
          [](double, LipScene& s) {
            s.person.paint = {0.05F, 0.62F, 0.2F};
          },
          Painted(13, 158, 51)),
      Make(
          "red-magenta paint",
          [](double, LipScene& s) {
            s.person.paint = {0.78F, 0.06F, 0.38F};
          },
          Painted(199, 15, 97)),
      Make("warm light",
           [](double, LipScene& s) {
             s.light.colour = {1.1F, 0.9F, 0.72F};
           }),
      Make("white balance towards blue",
           [](double, LipScene& s) {
             s.camera.balance = {0.85F, 1, 1.2F};
           }),
      In({640, 480, PixelFormat::kNv12}, 0, Make("NV12", plain)),
      In({640, 480, PixelFormat::kMjpeg}, 75, Make("JPEG of quality 75", plain)),
      In({320, 240, PixelFormat::kYuyv}, 0, Make("320 x 240", plain)),
      Make("a blue shirt",
           [](double, LipScene& s) {
             s.person.shirt = {0.13F, 0.25F, 0.7F};
           }),
      Make("half the mouth in shadow",
           [](double, LipScene& s) { s.light.shadow_from = 0.1, s.light.shadow_level = 0.35; }),
      Make("motion blur", [](double t, LipScene& s) { Smear(t, s, 0.5); }),
  };
}

std::vector<Condition> HardSet() {
  using sim::LipScene;
  return {
      Make("a hand that passes", [](double t, LipScene& s) { s.person.hand = 3.0 - 3.0 * t; }),
      Make("darkness and noise",
           [](double, LipScene& s) { s.light.level = 0.1, s.camera.gain = 2, s.camera.noise_steps = 14; }),
      Make("deep shadow on half the mouth",
           [](double, LipScene& s) { s.light.shadow_from = 0.0, s.light.shadow_level = 0.05; }),
      Make("a shadow that wanders",
           [](double t, LipScene& s) {
             s.light.shadow_from = 0.8 * Wave(t, 0.7), s.light.shadow_level = 0.25;
           }),
      Make("amber light",
           [](double, LipScene& s) {
             s.light.colour = {1.2F, 0.75F, 0.35F};
           }),
      Make("blue light",
           [](double, LipScene& s) {
             s.light.colour = {0.5F, 0.6F, 1.2F};
           }),
      In({640, 480, PixelFormat::kMjpeg}, 25,
         Make("JPEG of quality 25", [](double, LipScene& s) { s.camera.noise_steps = 4; })),
      Make("no marker: a head that comes nearer",
           [](double t, LipScene& s) { s.person.head = Swaying(t, 0.3, 0.2, 0.15); }),
      Make("a head that swings", [](double t, LipScene& s) { Smear(t, s, 1.2); }),
      Make("half a smile",
           [](double t, LipScene& s) { s.person.smile_left = t > 0 ? 0.1 + 0.1 * Wave(t, 0.5) : 0; }),
      In({160, 120, PixelFormat::kYuyv}, 0, Make("160 x 120", [](double, LipScene&) {})),
  };
}

Truth MeasureTruth(const Condition& condition, int frames) {
  Shooting shooting(condition);
  LipMeter meter(condition.settings, {});
  decode::PlaneReader reader;
  Time at = Time{} + std::chrono::seconds(1);
  ParseArguments(shooting, meter, at);
  Truth truth{.name = condition.name, .frames = frames};
  int believed = 0;
  int lost = 0;
  for (int n = 1; n <= frames; ++n) {
    const double time_s = n / kFramesPerSecond;
    const sim::LipScene scene = shooting.SceneAt(time_s, static_cast<std::uint32_t>(n));
    const auto planes = reader.Read(shooting.Shoot(scene));
    const board::Lips& lips = meter.Measure(*planes, at + FromSeconds(time_s));
    lost = lips.quality < kBelieved ? lost + 1 : 0;
    truth.longest_loss_ms = std::max(truth.longest_loss_ms, 1e3 * lost / kFramesPerSecond);
    if (lost > 0) continue;
    ++believed;
    const sim::Mouth& mouth = scene.person.mouth;
    truth.height_error += std::abs(static_cast<double>(lips.height) - mouth.height);
    truth.width_error += std::abs(static_cast<double>(lips.width) - mouth.width);
    truth.opening_error += std::abs(static_cast<double>(lips.opening) - std::max(0.0, mouth.height - kShut));
  }
  for (double* error : {&truth.height_error, &truth.width_error, &truth.opening_error})
    *error = believed > 0 ? *error / believed : 1;
  return truth;
}

}  // namespace kaori::lips
