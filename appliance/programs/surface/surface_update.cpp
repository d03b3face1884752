#include "appliance/programs/surface/surface_update.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "appliance/programs/surface/surface_command.h"
#include "drivers/base/read_file.h"
#include "firmware/wire/dial_box.h"

namespace kaori::surface_update {
namespace {

using wire::SurfaceOperation;

// ReadFile refuses a larger file: it is no update of a surface.
constexpr std::size_t kMostUpdateBytes = 512UL * 1024;
// How often the sending is begun before the update has failed.
constexpr int kMostAttempts = 3;
// A cable that is loose: a surface that dies is back with the image before after three.
constexpr int kMostLosses = 6;
// Pieces of wire::kSurfaceDataBytes (56) in one step, so that the caller's loop goes round meanwhile.
constexpr int kPiecesAtOnce = 8;
// How long the port may stay without an answer before the update has failed: from the first step on, and anew
// over each restart.
constexpr Duration kAnswerTime = std::chrono::seconds(15);
// How often a surface that tries the new image is asked for its version.
constexpr Duration kAskEvery = std::chrono::milliseconds(250);

}  // namespace

// The larger number is the later version: each half has 16 bits in the report.
std::uint32_t VersionOf(const wire::SurfaceStatus& status) {
  return std::uint32_t{status.firmware_major} << 16U | status.firmware_minor;
}

std::string VersionWords(std::uint32_t version) {
  return fmt::format("{}.{}", version >> 16U, version & 0xFFFFU);
}

// Only lengths are judged here. Product, version and the hash of the image are the surface's to check: it
// answers with a STALL what it refuses (wire/surface_feature.h).
Result<UpdateFile> ReadUpdateFile(const std::filesystem::path& file) {
  const auto text = ReadFile(file, {.most_bytes = kMostUpdateBytes});
  if (!text) return tl::unexpected(text.error());
  const std::vector<std::uint8_t> bytes(text->begin(), text->end());
  if (bytes.size() <= wire::kSurfaceImageBytes)
    return FailInput(file.string() + ": is no update of a surface, since it is too short");
  UpdateFile update{.image = wire::DecodeSurfaceImage(std::span(bytes).first<wire::kSurfaceImageBytes>()),
                    .bytes = {}};
  update.bytes.assign(bytes.begin() + wire::kSurfaceImageBytes, bytes.end());
  if (update.image.length != update.bytes.size())
    return FailInput(fmt::format("{}: its image has {} bytes where its head says {}", file.string(),
                                 update.bytes.size(), update.image.length));
  return update;
}

// A dial box turns nothing while it restarts, so a running show keeps one that plays. Stick pods are not
// counted.
Result<void> MayUpdate(const wire::SurfaceImage& image, const Circumstances& now) {
  const auto refuse = [](const char* why) { return FailInput(why, std::errc::operation_not_permitted); };
  if (!now.in_service) return refuse("surfaces are updated in service only: turn the key switch");
  if (now.show_runs && image.product == kDialBoxImage && now.dial_boxes < 2)
    return refuse("this is the last dial box of a running show: black the stage out, or plug another one in");
  return {};
}

// The report has no id; the first byte stands for it.
Result<wire::SurfaceStatus> ReadStatus(ports::HidChannel& channel) {
  std::array<std::uint8_t, 1 + wire::kSurfaceFeatureBytes> report{};
  const auto got = channel.GetFeature(report);
  if (!got) return tl::unexpected(got.error());
  if (*got != report.size())
    return kaori::Fail(std::errc::bad_message, "read what " + channel.identity().port + " says of itself");
  return wire::DecodeSurfaceStatus(std::span(report).subspan<1, wire::kSurfaceFeatureBytes>());
}

// Firmware that refuses for another reason, which there is none of today, would tell another stepping.
std::string RefusalWords(const wire::SurfaceStatus& status) {
  if (status.state != wire::SurfaceState::kRefuses) return {};
  const std::string_view stepping = status.stepping == wire::ChipStepping::kB0   ? "B0"
                                    : status.stepping == wire::ChipStepping::kB1 ? "B1"
                                                                                 : "of an unknown stepping";
  return fmt::format("refuses to play: its chip is an RP2040 {}, and only B2 and later ones may be used",
                     stepping);
}

// A box that does not answer may be on its way to a restart: it holds no show up.
bool IsPlayingDialBox(const ports::HidIdentity& identity, const Result<wire::SurfaceStatus>& status) {
  return ProductOf(identity) == kDialBoxImage && status && status->state != wire::SurfaceState::kRefuses;
}

SurfaceUpdate::SurfaceUpdate(ports::HidBus& bus, std::string port, const UpdateFile& file)
    : bus_(bus), port_(std::move(port)), file_(file) {}

// One state may lead into the next within a step. The time to give up counts from the first step, since the
// constructor knows no time.
void SurfaceUpdate::Step(Time now) {
  if (give_up_at_ == Time{}) give_up_at_ = now + kAnswerTime;
  if (state_ == State::kSending) Send(now);
  if (state_ == State::kRestarting) AwaitRestart(now);
  if (state_ == State::kTrying) Watch(now);
}

// The list of ports is asked first: over a restart an empty port is the usual state, and opening it would
// only fail.
bool SurfaceUpdate::HasChannel() {
  if (channel_) return true;
  const auto ports = bus_.Ports();
  if (!ports || std::ranges::find(*ports, port_) == ports->end()) return false;
  auto channel = bus_.Open(port_);
  if (channel) channel_ = std::move(*channel);
  return channel_ != nullptr;
}

// `data` has at most wire::kSurfaceDataBytes; what it leaves free is 0.
Result<void> SurfaceUpdate::Command(SurfaceOperation operation, std::span<const std::uint8_t> data,
                                    std::uint32_t offset) {
  wire::SurfaceCommand command{.operation = operation,
                               .length = static_cast<std::uint16_t>(data.size()),
                               .offset = offset,
                               .data = {}};
  std::ranges::copy(data, command.data.begin());
  return surface_update::Send(*channel_, command);
}

// A surface that went away, or lost its place, is begun with anew; one that refuses from the beginning is
// believed.
void SurfaceUpdate::Send(Time now) {
  if (!HasChannel()) {
    if (now >= give_up_at_) Fail("it is not there");
    return;
  }
  const bool had_begun = begun_;
  const auto ok = begun_ ? SendPieces() : Begin();
  give_up_at_ = now + kAnswerTime;
  if (ok || state_ == State::kFailed || state_ == State::kDone) return;
  channel_.reset();
  begun_ = false;
  const bool is_gone = ok.error().cause == std::errc::no_such_device;
  if (!had_begun && !is_gone)
    return Fail("it refuses the image: " + ok.error().message() +
                " (for another product, too long, or too old)");
  if (++attempts_ == kMostAttempts) Fail("it was begun three times: " + ok.error().message());
}

// Asks first what the surface plays: it may have the image already, or try it since before a loss of power.
// While it tries another one it is left alone, for that one is not confirmed.
Result<void> SurfaceUpdate::Begin() {
  const auto status = ReadStatus(*channel_);
  if (!status) return tl::unexpected(status.error());
  if (const auto why = RefusalWords(*status); !why.empty()) {
    Fail("it " + why);
    return {};
  }
  if (VersionOf(*status) == version_sent() && status->state == wire::SurfaceState::kPlays) {
    state_ = State::kDone;
    outcome_ = fmt::format("the surface at {} has version {} already", port_, VersionWords(version_sent()));
    return {};
  }
  // The power went after the image was whole: what it starts now is this one.
  if (status->state == wire::SurfaceState::kTries && VersionOf(*status) == version_sent()) {
    state_ = State::kRestarting;
    return {};
  }
  if (status->state == wire::SurfaceState::kTries) {
    Fail("it tries an image that nobody has confirmed; start it three times, and it plays the one before");
    return {};
  }
  sent_ = 0;
  if (auto ok = Command(SurfaceOperation::kBegin, wire::Encode(file_.image)); !ok) return ok;
  begun_ = true;
  return {};
}

// Some pieces, and after the last of them the restart. The restart's own answer may be lost with the cable's
// end.
Result<void> SurfaceUpdate::SendPieces() {
  for (int n = 0; n < kPiecesAtOnce && sent_ < file_.bytes.size(); ++n) {
    const auto piece =
        std::span(file_.bytes).subspan(sent_, std::min(wire::kSurfaceDataBytes, file_.bytes.size() - sent_));
    if (auto ok = Command(SurfaceOperation::kData, piece, static_cast<std::uint32_t>(sent_)); !ok) return ok;
    sent_ += piece.size();
  }
  if (sent_ < file_.bytes.size()) return {};
  if (auto ok = Command(SurfaceOperation::kEnd); !ok) return ok;
  (void)Command(SurfaceOperation::kRestart);
  channel_.reset();
  state_ = State::kRestarting;
  return {};
}

// While it says kReady it has not gone yet.
void SurfaceUpdate::AwaitRestart(Time now) {
  const auto status =
      HasChannel() ? ReadStatus(*channel_)
                   : Result<wire::SurfaceStatus>(kaori::Fail(std::errc::no_such_device, "open " + port_));
  if (status && status->state != wire::SurfaceState::kReady) {
    give_up_at_ = now + kAnswerTime;
    if (VersionOf(*status) != version_sent())
      return Fail(fmt::format("the new image did not start; it plays version {} as before",
                              VersionWords(VersionOf(*status))));
    // The firmware before did not ask its chip. It is not confirmed, so that the surface goes back to it.
    if (const auto why = RefusalWords(*status); !why.empty())
      return Fail("with the new image it " + why +
                  "; pull its cable and plug it in until it plays the image before, three times at most");
    state_ = State::kTrying;
    trying_since_ = asked_at_ = now;
    return;
  }
  channel_.reset();
  if (now >= give_up_at_)
    Fail(
        "it did not come back; pull its cable and plug it in: what is not confirmed is given up after three "
        "starts");
}

// Ten seconds in which it answers whenever it is asked.
void SurfaceUpdate::Watch(Time now) {
  if (now - asked_at_ < kAskEvery) return;
  asked_at_ = now;
  const auto status = ReadStatus(*channel_);
  if (!status || VersionOf(*status) != version_sent()) {
    if (++losses_ == kMostLosses) return Fail("it went away again and again while it tried the new image");
    channel_.reset();
    give_up_at_ = now + kAnswerTime;
    state_ = State::kRestarting;
    return;
  }
  if (now - trying_since_ < kProbation) return;
  if (now - trying_since_ >= kProbation + kAnswerTime) return Fail("it does not confirm the new image");
  if (auto kept = Command(SurfaceOperation::kKeep); !kept) return;
  const auto after = ReadStatus(*channel_);
  if (!after || after->state != wire::SurfaceState::kPlays) return;
  state_ = State::kDone;
  outcome_ = fmt::format("the surface at {} plays version {}", port_, VersionWords(version_sent()));
}

// The channel is closed at once: an update that has ended keeps no device open.
void SurfaceUpdate::Fail(std::string why) {
  channel_.reset();
  state_ = State::kFailed;
  outcome_ = fmt::format("the surface at {} was not updated: {}", port_, why);
}

}  // namespace kaori::surface_update
