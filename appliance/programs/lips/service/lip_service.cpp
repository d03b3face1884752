#include "appliance/programs/lips/service/lip_service.h"

#include "appliance/core/board/lines.h"

namespace kaori::lips {

Result<std::unique_ptr<LipService>> LipService::Open(const LipServiceOptions& options, LipReader& reader,
                                                     const board::Board& board, const Clock& clock) {
  auto writer = board.AcquireWriter<board::LipsGuide>();
  if (!writer) return tl::unexpected(writer.error());
  std::unique_ptr<LipService> service(new LipService(options, reader, board, std::move(*writer), clock));
  if (!options.service) return service;
  auto outlet = Outlet::Open(ServicePath(board.path()));
  if (!outlet) return tl::unexpected(outlet.error());
  service->outlet_.emplace(std::move(*outlet));
  return service;
}

LipService::LipService(const LipServiceOptions& options, LipReader& reader, const board::Board& board,
                       board::Writer<board::LipsGuide> writer, const Clock& clock)
    : service_(options.service),
      reader_(reader),
      board_(board),
      writer_(std::move(writer)),
      clock_(clock),
      tuning_(options.now, options.file,
              {.use = [&reader](const LipSettings& settings) { reader.Use(settings); },
               .light = [&reader](bool free) { free ? reader.care().Free() : reader.care().Hold(); }}) {
  reader_.Watch([this](const decode::Planes& planes, const LipMeter& meter, Time at) {
    const Time now = clock_.now();
    if (outlet_) outlet_->Show(planes, meter.key(), now);
    tuning_.See(planes, meter, at, now);  // Last: it may give the reader another meter.
  });
}

LipService::~LipService() {
  reader_.Watch(nullptr);
}

void LipService::Step() {
  const Time now = clock_.now();
  if (outlet_)
    for (const Command& command : outlet_->Hear(now)) tuning_.Do(command, now);
  tuning_.Step(now);
  guide_.Step(board_.Read<board::Keys>(), board_.Read<board::Surface>(), reader_.meter().lips().quality,
              tuning_, now);
  ShowGuide(now);
  if (outlet_) outlet_->Tell(tuning_.report(), now);
}

// By the key switch at the box.
bool LipService::ServiceSwitched() const {
  const auto lines = board_.Read<board::Lines>();
  return lines.source == board::SourceState::kLive && board::IsOn(lines.value, board::Line::kService);
}

// Written anew each time while it is under way, so that a reader sees when the lips are gone.
void LipService::ShowGuide(Time now) {
  if (guide_.active())
    writer_.Write(guide_.shown(service_ || ServiceSwitched()), now, board::SourceState::kLive);
  if (!guide_.active() && shown_) writer_.Write({}, now, board::SourceState::kAbsent);
  shown_ = guide_.active();
}

}  // namespace kaori::lips
