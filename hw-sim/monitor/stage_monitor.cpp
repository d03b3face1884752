#include "hw-sim/monitor/stage_monitor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "hw-sim/monitor/midi_text.h"

namespace kaori::sim {
namespace {

constexpr Duration kLookPeriod = std::chrono::seconds(1);
// A stage writes its status once a frame, so two seconds are no pause of one that lives.
constexpr Duration kSilence = std::chrono::seconds(2);

// In the order of board::LobbyState and of board::LobbyHours; nothing where there is nothing to be told.
constexpr std::array<const char*, board::kLobbyStateCount> kLobbyWords{
    "", "asleep", "waiting", "greeting", "with a visitor", "saying good-bye", "taken over"};
constexpr std::array<const char*, board::kLobbyHoursCount> kHoursWords{
    "", "", "Outside the opening hours", "The time of day is not known: no opening hours"};

// Each item in words, with its state, which is as board::CheckedState counts. Null where none was made on
// this box yet. One that runs and is silent has ended with its stage, and is none either.
json::Value CheckJson(const board::Stamped<board::LineCheck>& check, Time now) {
  const bool running = check.value.phase == board::LineCheckPhase::kRunning;
  if (check.source != board::SourceState::kLive || check.value.phase == board::LineCheckPhase::kNever ||
      (running && now - check.at >= kSilence))
    return {};
  json::List items;
  for (const board::CheckedItem& item : board::ItemsOf(check.value))
    items.push_back(json::List{std::string(board::DeviceOf(item)), board::PhraseOf(item),
                               static_cast<std::uint32_t>(item.state)});
  return json::Object{
      {"running", running}, {"summary", board::SummaryOf(check.value)}, {"items", std::move(items)}};
}

// Null while nobody teaches. The control has words once it is found; the restless one has none where all rest.
json::Value LearnJson(const board::Stamped<board::Learn>& learn, Time now) {
  const board::Learn& value = learn.value;
  const bool is_over = value.phase == board::LearnPhase::kNever || value.phase == board::LearnPhase::kEnded;
  if (learn.source != board::SourceState::kLive || is_over || now - learn.at >= kSilence) return {};
  const bool is_found = value.phase != board::LearnPhase::kAsking;
  return json::Object{{"phase", static_cast<std::uint32_t>(value.phase)},
                      {"choice", value.choice},
                      {"control", is_found ? board::NameOf(value.found) : std::string()},
                      {"inverted", value.inverted != 0},
                      {"instead", value.instead != 0},
                      {"restless", value.restless != 0 ? board::NameOf(value.moves_itself) : std::string()},
                      {"ambiguous", value.ambiguous != 0},
                      {"counts", value.turn_counts}};
}

json::List MotionsJson(const board::ShowNow& show) {
  json::List motions;
  for (const board::MotionShown& one : show.motions)
    if (one.motion >= 0)
      // Tenths, as people read them.
      motions.push_back(
          json::List{one.motion, std::floor(static_cast<double>(one.at_s) * 10) / 10, one.ends != 0});
  return motions;
}

// Oldest first. Numbers that the board's dials and buttons have not are none.
json::List MidiJson(const board::MidiHeard& heard) {
  using board::MidiHeard;
  const auto number = [](std::uint32_t meant) {
    return meant == MidiHeard::kNothing ? -1 : static_cast<std::int32_t>(meant);
  };
  json::List messages;
  const std::uint32_t kept = std::min<std::uint32_t>(heard.count, MidiHeard::kKept);
  for (std::uint32_t n = heard.count - kept; n != heard.count; ++n) {
    const MidiHeard::Message& message = heard.newest[n % MidiHeard::kKept];
    messages.push_back(
        json::List{n, fmt::format("{:04x}:{:04x}", message.device >> 16U, message.device & 0xFFFFU),
                   MidiText(message), number(message.meant & 0xFFU), number(message.meant >> 8U & 0xFFU)});
  }
  return messages;
}

}  // namespace

// Nothing: no stage writes the board. It is looked for once in a period, since each look opens a file.
std::optional<StageMonitor::Now> StageMonitor::Look() {
  const Time now = clock_.now();
  if (board_) {
    const auto status = board_->Read<board::StageStatus>();
    if (status.source == board::SourceState::kLive && now - status.at < kSilence)
      return Now{status.value, board_->Read<board::ShowNow>().value, board_->Read<board::LineCheck>(),
                 board_->Read<board::Learn>(), board_->Read<board::MidiHeard>().value};
  }
  // Looked for anew, since a stage that was started again may have made another file.
  if (now < look_at_) return std::nullopt;
  look_at_ = now + kLookPeriod;
  board_.reset();
  if (auto opened = board::Board::Open(path_)) board_.emplace(std::move(*opened));
  return std::nullopt;
}

json::Value StageMonitor::Read() {
  const auto now = Look();
  if (!now) return {};
  const board::ShowNow& show = now->show;
  const auto is = [&](board::CueState state) { return (show.cue_state & state) != 0; };
  // Four digits are finer than a person sees, and equal states give equal text.
  json::List levels;
  for (const auto& [value, owner, role] : show.levels)
    levels.push_back(json::List{std::round(static_cast<double>(value) * 1e4) / 1e4,
                                static_cast<std::uint32_t>(owner), role});
  return json::Object{{"scene", now->status.scene},
                      {"style", now->status.style},
                      {"cue", show.cue_active},
                      {"standby", show.cue_standby},
                      {"pending", show.cue_pending},
                      // Tenths, as people read them: a state that looks the same is the same text.
                      {"left_s", std::ceil(static_cast<double>(show.cue_left_s) * 10) / 10},
                      {"paused", is(board::kCuesPaused)},
                      {"panicking", is(board::kCuesPanicking)},
                      {"black", is(board::kCuesBlack)},
                      {"waiting", is(board::kCuesWaiting)},
                      {"refused", show.gos_refused},
                      {"sheet", show.sheet},
                      {"levels", std::move(levels)},
                      {"locked", show.locked != 0},
                      {"locked_out", show.locked_out},
                      {"lobby", kLobbyWords[static_cast<std::size_t>(show.lobby)]},
                      {"lobby_hours", kHoursWords[static_cast<std::size_t>(show.lobby_hours)]},
                      {"check", CheckJson(now->check, clock_.now())},
                      {"learn", LearnJson(now->learn, clock_.now())},
                      {"role_devices", json::ListOf(show.role_devices)},
                      {"motions", MotionsJson(show)},
                      {"midi", MidiJson(now->midi)}};
}

}  // namespace kaori::sim
