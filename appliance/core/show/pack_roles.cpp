#include "appliance/core/show/pack_roles.h"

#include "appliance/core/show/pack_calls.h"

namespace kaori::show {
namespace {

// Controls, levels and take-overs are stored as numbers: their order in roles.h and
// level.h is part of the format.
flatbuffers::Offset<pack::RoleMap> WriteMap(flatbuffers::FlatBufferBuilder& to, const RoleMap& map) {
  const auto points = to.CreateVectorOfStructs(AsStored<pack::Vec2>(map.points), map.points.size());
  return pack::CreateRoleMap(to, static_cast<std::uint32_t>(map.control), map.dial,
                             static_cast<std::uint32_t>(map.level), map.from, map.to, map.dead, map.exponent,
                             points, static_cast<std::uint32_t>(map.takeover));
}

// Parts before the table that names them, as in pack_writer.cpp.
flatbuffers::Offset<pack::Role> WriteRole(flatbuffers::FlatBufferBuilder& to, const Role& role) {
  const auto name = to.CreateString(role.name);
  std::vector<flatbuffers::Offset<pack::RoleMap>> offsets;
  for (const RoleMap& map : role.maps) offsets.push_back(WriteMap(to, map));
  const auto maps = to.CreateVector(offsets);
  return pack::CreateRole(to, name, static_cast<std::uint32_t>(role.device), maps);
}

// Numbers that are no control, level or take-over stay so, or become 255, and CheckRoles names them.
RoleMap ReadMap(Copier& from, const pack::RoleMap& stored) {
  return {.control = static_cast<Control>(Narrow<std::uint8_t>(stored.control())),
          .dial = Narrow<std::uint8_t>(stored.dial()),
          .level = static_cast<Level>(Narrow<std::uint8_t>(stored.level())),
          .from = stored.from(),
          .to = stored.to(),
          .dead = stored.dead(),
          .exponent = stored.exponent(),
          .points = from.Structs<glm::vec2>(stored.points()),
          .takeover = static_cast<Takeover>(Narrow<std::uint8_t>(stored.takeover()))};
}

Role ReadRole(Copier& from, const pack::Role& stored) {
  return {.name = from.Text(stored.name()),
          .device = static_cast<Device>(Narrow<std::uint8_t>(stored.device())),
          .maps = from.Tables<RoleMap>(stored.maps(), ReadMap)};
}

}  // namespace

flatbuffers::Offset<pack::Roles> WriteRoles(flatbuffers::FlatBufferBuilder& to, const Roles& roles) {
  std::vector<flatbuffers::Offset<pack::Role>> offsets;
  for (const Role& role : roles.roles) offsets.push_back(WriteRole(to, role));
  const auto all = to.CreateVector(offsets);
  const auto mixes = to.CreateVectorOfStructs(StoredCalls(roles.mixes));
  return pack::CreateRoles(to, roles.handover_s, all, mixes);
}

// A pack from before there were roles plays as the box did then. More mixes than there are levels for are
// left out, and maps that want those are refused by CheckRoles.
Roles ReadRoles(Copier& from, const pack::Roles* stored) {
  if (stored == nullptr) return UsualRoles();
  Roles roles{.handover_s = stored->handover_s(), .roles = from.Tables<Role>(stored->roles(), ReadRole)};
  if (stored->mixes() != nullptr)
    for (flatbuffers::uoffset_t i = 0; i < stored->mixes()->size() && i < kMixCount; ++i)
      roles.mixes.push_back(HeldCall(*stored->mixes()->Get(i)));
  return roles;
}

}  // namespace kaori::show
