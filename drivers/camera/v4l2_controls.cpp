#include "drivers/camera/v4l2_controls.h"

#include <linux/videodev2.h>

#include <array>

namespace kaori::camera {
namespace {

// Stands for "there is no second control" in the table below; V4L2 has no control 0.
constexpr std::uint32_t kNoControl = 0;
// V4L2_CID_EXPOSURE_ABSOLUTE counts in steps of 100 us
// (media/v4l/ext-ctrls-camera.html), as UVC 1.5 does (4.2.2.1.4).
constexpr double kExposureStep_s = 1e-4;
constexpr double kMainsFlicker_hz = 100;  // Of 50 Hz mains; that of 60 Hz is faster yet.

// Something that a camera sets by itself, and by which controls that is switched and read.
struct Automatic {
  const char* name;
  std::uint32_t by_itself;
  std::array<std::int32_t, 2> free;  // The first that the camera takes.
  std::int32_t held;
  std::array<std::uint32_t, 2> values;  // What is read while free and written when held.
};

// Exposure first: while it is automatic many cameras refuse the gain.
constexpr std::array<Automatic, 4> kAutomatics = {{
    {"exposure",
     V4L2_CID_EXPOSURE_AUTO,
     {V4L2_EXPOSURE_APERTURE_PRIORITY, V4L2_EXPOSURE_AUTO},
     V4L2_EXPOSURE_MANUAL,
     {V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_EXPOSURE}},
    {"gain", V4L2_CID_AUTOGAIN, {1, 1}, 0, {V4L2_CID_GAIN, V4L2_CID_ANALOGUE_GAIN}},
    {"white balance",
     V4L2_CID_AUTO_WHITE_BALANCE,
     {1, 1},
     0,
     {V4L2_CID_WHITE_BALANCE_TEMPERATURE, V4L2_CID_RED_BALANCE}},
    {"focus", V4L2_CID_FOCUS_AUTO, {1, 1}, 0, {V4L2_CID_FOCUS_ABSOLUTE, kNoControl}},
}};

// Whether the camera has the control and accepted the value. S_CTRL of some drivers clamps silently.
bool Write(V4l2Calls& calls, int fd, std::uint32_t control, std::int32_t value) {
  v4l2_control request{.id = control, .value = value};
  return calls.Ioctl(fd, VIDIOC_S_CTRL, &request) == 0;
}

std::optional<std::int32_t> Read(V4l2Calls& calls, int fd, std::uint32_t control) {
  v4l2_control request{.id = control, .value = 0};
  if (calls.Ioctl(fd, VIDIOC_G_CTRL, &request) < 0) return std::nullopt;
  return request.value;
}

// Disabled controls answer queries, and refuse to be set.
bool Has(V4l2Calls& calls, int fd, std::uint32_t control) {
  v4l2_queryctrl query{};
  query.id = control;
  return control != kNoControl && calls.Ioctl(fd, VIDIOC_QUERYCTRL, &query) == 0 &&
         (query.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
}

// Sets those of the values that belong to this automatic.
bool WriteAll(V4l2Calls& calls, int fd, const Automatic& of, std::span<const V4l2Value> values) {
  bool done = true;
  for (const V4l2Value& value : values) {
    if (value.control == of.values[0] || value.control == of.values[1])
      done = Write(calls, fd, value.control, value.value) && done;
  }
  return done;
}

bool HasAny(V4l2Calls& calls, int fd, const Automatic& of) {
  return Has(calls, fd, of.by_itself) || Has(calls, fd, of.values[0]) || Has(calls, fd, of.values[1]);
}

}  // namespace

std::vector<std::string> FreeControls(V4l2Calls& calls, int fd) {
  std::vector<std::string> passed_over;
  for (const Automatic& automatic : kAutomatics) {
    const bool free = Write(calls, fd, automatic.by_itself, automatic.free[0]) ||
                      Write(calls, fd, automatic.by_itself, automatic.free[1]);
    if (!free) passed_over.emplace_back(automatic.name);
  }
  // Else a dark picture halves the rate. Few cameras but webcams have it, and those without keep their rate.
  Write(calls, fd, V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0);
  return passed_over;
}

std::vector<V4l2Value> ReadControls(V4l2Calls& calls, int fd) {
  std::vector<V4l2Value> values;
  for (const Automatic& automatic : kAutomatics) {
    for (const std::uint32_t control : automatic.values) {
      if (!Has(calls, fd, control)) continue;
      if (const auto value = Read(calls, fd, control)) values.push_back({control, *value});
    }
  }
  return values;
}

// A gain without an automatic of its own goes with the exposure: its value alone holds it.
std::vector<std::string> HoldControls(V4l2Calls& calls, int fd, std::span<const V4l2Value> values) {
  std::vector<std::string> passed_over;
  for (const Automatic& automatic : kAutomatics) {
    const bool switched =
        !Has(calls, fd, automatic.by_itself) || Write(calls, fd, automatic.by_itself, automatic.held);
    const bool set = WriteAll(calls, fd, automatic, values);
    if (!switched || !set || !HasAny(calls, fd, automatic)) passed_over.emplace_back(automatic.name);
  }
  Write(calls, fd, V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0);
  return passed_over;
}

void FitMains(V4l2Calls& calls, int fd, double rate_hz) {
  if (rate_hz > kMainsFlicker_hz)
    Write(calls, fd, V4L2_CID_POWER_LINE_FREQUENCY, V4L2_CID_POWER_LINE_FREQUENCY_DISABLED);
}

std::optional<double> ExposureSeconds(V4l2Calls& calls, int fd) {
  const auto steps =
      Has(calls, fd, V4L2_CID_EXPOSURE_ABSOLUTE) ? Read(calls, fd, V4L2_CID_EXPOSURE_ABSOLUTE) : std::nullopt;
  if (!steps) return std::nullopt;
  return *steps * kExposureStep_s;
}

}  // namespace kaori::camera
