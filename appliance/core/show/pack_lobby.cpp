#include "appliance/core/show/pack_lobby.h"

namespace kaori::show {
namespace {

using StoredTakes = flatbuffers::Vector<flatbuffers::Offset<pack::LobbyTake>>;

// Texts before the tables that name them, and tables before their vector, as in pack_writer.cpp.
flatbuffers::Offset<StoredTakes> WriteTakes(flatbuffers::FlatBufferBuilder& to,
                                            const std::vector<LobbyTake>& takes) {
  std::vector<flatbuffers::Offset<pack::LobbyTake>> offsets;
  for (const LobbyTake& take : takes) {
    const auto language = to.CreateString(take.language);
    offsets.push_back(pack::CreateLobbyTake(to, language, take.motion));
  }
  return to.CreateVector(offsets);
}

std::vector<LobbyTake> ReadTakes(Copier& from, const StoredTakes* stored) {
  return from.Tables<LobbyTake>(stored, [](Copier& copier, const pack::LobbyTake& take) {
    return LobbyTake{copier.Text(take.language()), take.motion()};
  });
}

}  // namespace

flatbuffers::Offset<pack::Lobby> WriteLobby(flatbuffers::FlatBufferBuilder& to,
                                            const std::optional<Lobby>& lobby) {
  if (!lobby) return {};
  const auto greetings = WriteTakes(to, lobby->greetings);
  const auto stays = WriteTakes(to, lobby->stays);
  const auto goodbyes = WriteTakes(to, lobby->goodbyes);
  std::vector<pack::LobbyOpening> openings;
  for (const OpenSpan& opening : lobby->hours) openings.emplace_back(opening.from, opening.to);
  const auto hours = to.CreateVectorOfStructs(openings);
  return pack::CreateLobby(to, lobby->cue, lobby->by_itself, greetings, stays, goodbyes, lobby->visitor,
                           lobby->arrive_s, lobby->leave_s, lobby->stay_s, lobby->sleep_s, lobby->sleep_light,
                           lobby->hand_back_s, hours, lobby->stuck_s);
}

// One opening more than is allowed is read, so that CheckLobby finds it.
std::optional<Lobby> ReadLobby(Copier& from, const pack::Lobby* stored) {
  if (stored == nullptr) return std::nullopt;
  Lobby lobby{.cue = stored->cue(),
              .by_itself = stored->by_itself(),
              .greetings = ReadTakes(from, stored->greetings()),
              .stays = ReadTakes(from, stored->stays()),
              .goodbyes = ReadTakes(from, stored->goodbyes()),
              .visitor = stored->visitor(),
              .arrive_s = stored->arrive_s(),
              .leave_s = stored->leave_s(),
              .stuck_s = stored->stuck_s(),
              .stay_s = stored->stay_s(),
              .sleep_s = stored->sleep_s(),
              .sleep_light = stored->sleep_light(),
              .hand_back_s = stored->hand_back_s(),
              .hours = {}};
  if (stored->hours() != nullptr)
    for (flatbuffers::uoffset_t i = 0; i < stored->hours()->size() && i <= kMostOpenings; ++i)
      lobby.hours.push_back({stored->hours()->Get(i)->from(), stored->hours()->Get(i)->to()});
  return lobby;
}

}  // namespace kaori::show
