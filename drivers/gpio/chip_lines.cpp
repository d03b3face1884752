#include "drivers/gpio/chip_lines.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <utility>

#include "drivers/gpio/background_lines.h"

namespace kaori::gpio {
namespace {

using ports::GpioEdge;

// The bits of Levels().
constexpr std::size_t kMostInputs = 32;

// Adds a descriptor to the lines' epoll set.
Result<void> WatchIn(const UniqueFd& epoll, int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  if (::epoll_ctl(epoll.get(), EPOLL_CTL_ADD, fd, &event) < 0) return FailErrno("watch a GPIO line");
  return {};
}

}  // namespace

// All or none: lines that were requested before one that fails are released with `lines`.
Result<std::unique_ptr<ChipLines>> ChipLines::Request(std::unique_ptr<GpioChip> chip, const Wiring& wiring) {
  if (wiring.inputs.size() > kMostInputs) return FailInput("request more than 32 GPIO inputs");
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  UniqueFd wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!epoll.valid() || !wake.valid()) return FailErrno("watch GPIO lines");
  if (auto ok = WatchIn(epoll, wake.get()); !ok) return tl::unexpected(ok.error());
  std::unique_ptr<ChipLines> lines(new ChipLines(std::move(chip), std::move(epoll), std::move(wake)));
  for (const LineWiring& input : wiring.inputs)
    if (auto ok = lines->AddInput(input); !ok) return tl::unexpected(ok.error());
  for (const LineWiring& output : wiring.outputs) {
    auto line = lines->chip_->RequestOutput(output);
    if (!line) return tl::unexpected(line.error());
    lines->outputs_.push_back(std::move(*line));
  }
  return lines;
}

ChipLines::ChipLines(std::unique_ptr<GpioChip> chip, UniqueFd epoll, UniqueFd wake)
    : chip_(std::move(chip)), epoll_(std::move(epoll)), wake_(std::move(wake)) {}

Result<void> ChipLines::AddInput(const LineWiring& wiring) {
  // The index stays that of the wiring, so that roles keep their lines.
  if (!wiring.wired) {
    inputs_.emplace_back();
    return {};
  }
  auto line = chip_->RequestInput(wiring);
  if (!line) return tl::unexpected(line.error());
  if (auto ok = WatchIn(epoll_, (*line)->pollable()); !ok) return ok;
  inputs_.push_back({.line = std::move(*line), .next = {}});
  return {};
}

// Asks every line, so that the levels of two lines may be from different moments. Edges tell their order.
Result<std::uint32_t> ChipLines::Levels() {
  std::uint32_t active = 0;
  for (std::size_t n = 0; n < inputs_.size(); ++n) {
    if (!inputs_[n].line) continue;
    const auto level = inputs_[n].line->Level();
    if (!level) return tl::unexpected(level.error());
    if (*level) active |= std::uint32_t{1} << n;
  }
  return active;
}

Result<GpioEdge> ChipLines::ReadEdge() {
  if (auto ok = ReadAhead(); !ok) return tl::unexpected(ok.error());
  // Inputs without an edge are later than any with one. The time of two edges may be
  // equal: then the line with the lower number comes first.
  const auto oldest = std::ranges::min_element(
      inputs_, {}, [](const Input& input) { return input.next ? input.next->at : Time::max(); });
  if (oldest == inputs_.end() || !oldest->next)
    return Fail(std::errc::resource_unavailable_try_again, "read GPIO lines");
  const LineEdge edge = *std::exchange(oldest->next, std::nullopt);
  UpdateWake();
  return GpioEdge{
      .at = edge.at, .line = static_cast<std::uint32_t>(oldest - inputs_.begin()), .active = edge.active};
}

// Reads every line's next edge: only all of them together tell which one is the oldest.
Result<void> ChipLines::ReadAhead() {
  for (Input& input : inputs_) {
    if (input.next || !input.line) continue;
    const auto edge = input.line->ReadEdge();
    if (edge) input.next = *edge;
    if (!edge && edge.error().cause != std::errc::resource_unavailable_try_again)
      return tl::unexpected(edge.error());
  }
  return {};
}

void ChipLines::UpdateWake() {
  eventfd_t count = 0;
  // The kernel no longer knows of an edge that was read ahead: its descriptor would not wake the program.
  const bool any = std::ranges::any_of(inputs_, [](const Input& input) { return input.next.has_value(); });
  if (any)
    ::eventfd_write(wake_.get(), 1);
  else
    ::eventfd_read(wake_.get(), &count);  // Non-blocking: empty is as good.
}

Result<void> ChipLines::Drive(std::uint32_t line, bool active) {
  if (line >= outputs_.size())
    return FailInput("drive GPIO output " + std::to_string(line) + ", which is not wired");
  return outputs_[line]->Drive(active);
}

Result<std::unique_ptr<ports::GpioLines>> OpenLines(const std::string& chip, const Wiring& wiring,
                                                    const Clock& clock) {
  auto opened = OpenGpioChip(chip, clock);
  if (!opened) return tl::unexpected(opened.error());
  auto lines = ChipLines::Request(std::move(*opened), wiring);
  if (!lines) return tl::unexpected(lines.error());
  return BackgroundLines::Begin(std::move(*lines), wiring.outputs.size(), clock);
}

}  // namespace kaori::gpio
