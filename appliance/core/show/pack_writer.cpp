#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "appliance/core/show/pack_calls.h"
#include "appliance/core/show/pack_content.h"
#include "appliance/core/show/pack_cues.h"
#include "appliance/core/show/pack_layout.h"
#include "appliance/core/show/pack_lobby.h"
#include "appliance/core/show/pack_roles.h"

namespace kaori::show {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

// The builder grows by copying; one guess that fits most shows spares that.
constexpr std::size_t kFirstGuessBytes = 64U << 20U;

// Children before parents: FlatBuffers writes from back to front, so that each function makes the parts of a
// table first and the table last, in the order of pack.fbs.
template <class Stored, class Held>
auto Structs(FlatBufferBuilder& to, const std::vector<Held>& held) {
  return to.CreateVectorOfStructs(AsStored<Stored>(held), held.size());
}

pack::Vec3 Vec(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

Offset<pack::SparseRows> Write(FlatBufferBuilder& to, const face::SparseRows& rows) {
  const auto start = to.CreateVector(rows.row_start);
  const auto column = to.CreateVector(rows.column);
  const auto weight = to.CreateVector(rows.weight);
  return pack::CreateSparseRows(to, start, column, weight);
}

Offset<pack::FineMesh> Write(FlatBufferBuilder& to, const face::FineMesh& fine) {
  const auto from_cage = Write(to, fine.from_cage);
  const auto attributes = Write(to, fine.attributes_from_cage);
  const auto triangles = Structs<pack::Triangle>(to, fine.triangles);
  const auto texture = Structs<pack::Vec2>(to, fine.texture);
  const auto twin = to.CreateVector(fine.twin);
  return pack::CreateFineMesh(to, from_cage, attributes, triangles, texture, twin);
}

Offset<pack::LidRig> Write(FlatBufferBuilder& to, const face::LidRig& rig) {
  const auto upper = to.CreateVector(rig.upper);
  const auto lower = to.CreateVector(rig.lower);
  const auto follow_upper = to.CreateVector(rig.follow_upper);
  const auto follow_lower = to.CreateVector(rig.follow_lower);
  return pack::CreateLidRig(to, rig.columns, rig.rings, rig.margin_ring, upper, lower, follow_upper,
                            follow_lower);
}

Offset<pack::Topology> Write(FlatBufferBuilder& to, const face::Topology& topology) {
  const auto uv = Structs<pack::Vec2>(to, topology.uv);
  const auto texture = Structs<pack::Vec2>(to, topology.texture);
  const auto triangles = Structs<pack::Triangle>(to, topology.triangles);
  const auto wires = Structs<pack::Line>(to, topology.wires);
  const auto twin = to.CreateVector(topology.twin);
  const auto mouth_share = to.CreateVector(topology.mouth_share);
  const auto lids = to.CreateVector({Write(to, topology.lids[0]), Write(to, topology.lids[1])});
  const auto fine = Write(to, topology.fine);
  const auto outgrowth = to.CreateVector(topology.outgrowth);
  return pack::CreateTopology(to, topology.vertex_count, topology.moving_count, uv, texture, triangles, wires,
                              twin, mouth_share, lids, fine, outgrowth);
}

Offset<pack::ControlNet> Write(FlatBufferBuilder& to, const face::ControlNet& net) {
  std::vector<std::string> names;
  std::vector<glm::vec2> uvs;
  for (const auto& point : net.points) {
    names.push_back(point.name);
    uvs.push_back(point.uv);
  }
  const auto stored_names = to.CreateVectorOfStrings(names);
  const auto stored_uvs = Structs<pack::Vec2>(to, uvs);
  const auto to_cage = Write(to, net.to_cage);
  const auto surface = Write(to, net.surface);
  return pack::CreateControlNet(to, stored_names, stored_uvs, to_cage, surface);
}

// Both eyes are written as they lie in memory; the reader's SameBytes keeps the two layouts equal.
Offset<pack::Face> Write(FlatBufferBuilder& to, const face::Face& face) {
  const auto name = to.CreateString(face.name);
  const auto positions = Structs<pack::Vec3>(to, face.positions);
  const auto occlusion = to.CreateVector(face.occlusion);
  const auto eyes = to.CreateVectorOfStructs(reinterpret_cast<const pack::EyeBall*>(face.eyes.data()), 2);
  const auto props = to.CreateVector(face.props);
  const auto withdrawn = Structs<pack::Vec3>(to, face.withdrawn);
  const auto sparse = Structs<pack::Triangle>(to, face.sparse);
  const auto hang_arms = Structs<pack::Vec2>(to, face.hang_arms_m);
  const pack::EyeLook eye_look(Vec(face.eye_look.iris), face.eye_look.iris_radius_m,
                               face.eye_look.lash_length_m, face.eye_look.lash_wing_m);
  const face::EyeSurface& ball = face.eye_surface;
  const pack::EyeSurface eye_surface(Vec(ball.white), ball.veins, ball.pupil, ball.limbus, ball.spokes,
                                     ball.rings, ball.wet, ball.glow);
  const pack::MouthFit mouth(face.mouth.scale, Vec(face.mouth.offset), face.mouth.upper_teeth,
                             face.mouth.lower_teeth, face.mouth.tongue);
  const pack::Vec3 flat = Vec(face.surface.flat);
  return pack::CreateFace(to, name, positions, occlusion, eyes, &eye_look, &mouth, face.surface.softness,
                          face.surface.metal, face.surface.texture, &flat, props, face.expression_gain,
                          face.surface.print, &eye_surface, face.outgrowth_kind, withdrawn, sparse, hang_arms,
                          face.surface.folds, face.surface.flush);
}

Offset<pack::Expression> Write(FlatBufferBuilder& to, const face::Expression& expression) {
  const auto name = to.CreateString(expression.name);
  const auto displacement = Structs<pack::Vec3>(to, expression.displacement);
  const auto residual = Structs<pack::Vec3>(to, expression.residual);
  return pack::CreateExpression(to, name, static_cast<std::uint32_t>(expression.kind), displacement,
                                expression.lids[0], expression.lids[1], residual, expression.pupil,
                                expression.flush);
}

Offset<pack::Prop> Write(FlatBufferBuilder& to, const face::Prop& prop) {
  const auto name = to.CreateString(prop.name);
  const auto vertices = Structs<pack::PropVertex>(to, prop.vertices);
  const auto triangles = Structs<pack::Triangle>(to, prop.triangles);
  const pack::Vec3 colour = Vec(prop.colour);
  return pack::CreateProp(to, name, static_cast<std::uint32_t>(prop.part), &colour, vertices, triangles);
}

Offset<pack::Texture> Write(FlatBufferBuilder& to, const face::Texture& texture) {
  return pack::CreateTexture(to, texture.width_px, texture.height_px,
                             to.CreateVector(texture.rgba.data(), texture.rgba.size()));
}

Offset<pack::MotionCurve> Write(FlatBufferBuilder& to, const MotionCurve& curve) {
  const auto keys = Structs<pack::MotionKey>(to, curve.keys);
  return pack::CreateMotionCurve(to, static_cast<std::uint32_t>(curve.target), curve.channel, keys);
}

// Declared first, since WriteAll finds its overloads where it is defined.
Offset<pack::Motion> Write(FlatBufferBuilder& to, const Motion& motion);
Offset<pack::StageScene> Write(FlatBufferBuilder& to, const StageScene& scene);
Offset<pack::GazeTarget> Write(FlatBufferBuilder& to, const GazeTarget& target);
Offset<pack::KeyPicture> Write(FlatBufferBuilder& to, const KeyPicture& key);

// A vector of tables; offsets are those that Write gave for each.
template <class T>
auto WriteAll(FlatBufferBuilder& to, const std::vector<T>& all) {
  std::vector<decltype(Write(to, all.front()))> offsets;
  for (const T& one : all) offsets.push_back(Write(to, one));
  return to.CreateVector(offsets);
}

Offset<pack::Motion> Write(FlatBufferBuilder& to, const Motion& motion) {
  const auto name = to.CreateString(motion.name);
  const auto curves = WriteAll(to, motion.curves);
  const auto sound = to.CreateVector(motion.sound.samples);
  return pack::CreateMotion(to, name, motion.key_usage, curves,
                            static_cast<std::uint32_t>(motion.sound.channels), sound, motion.recorded,
                            motion.loop_from_s, motion.loop_to_s, static_cast<std::uint32_t>(motion.layer));
}

Offset<pack::StageScene> Write(FlatBufferBuilder& to, const StageScene& scene) {
  const auto name = to.CreateString(scene.name);
  const pack::Vec3 top = Vec(scene.backdrop.top);
  const pack::Vec3 bottom = Vec(scene.backdrop.bottom);
  const pack::Vec3 glow = Vec(scene.backdrop.glow);
  return pack::CreateStageScene(to, name, scene.key_usage, scene.face, scene.expression,
                                static_cast<std::uint32_t>(scene.style), &top, &bottom, scene.exposure,
                                scene.fade_s, static_cast<std::uint32_t>(scene.backdrop.kind), &glow,
                                scene.backdrop.picture, &AsStored<pack::LifeAmounts>(scene.life), scene.gaze);
}

Offset<pack::GazeTarget> Write(FlatBufferBuilder& to, const GazeTarget& target) {
  const auto name = to.CreateString(target.name);
  const pack::Vec3 at = Vec(target.at_m);
  return pack::CreateGazeTarget(to, name, &at);
}

Offset<pack::KeyPicture> Write(FlatBufferBuilder& to, const KeyPicture& key) {
  const auto file = to.CreateVector(key.file);
  return pack::CreateKeyPicture(to, key.key_px, key.call, key.is_lit, file);
}

// Arguments stand in the order of the fields in pack.fbs, which grows at its end alone: a field in between
// would renumber all behind it, and older packs would be misread.
Offset<pack::Pack> Write(FlatBufferBuilder& to, const Show& show, const std::vector<KeyPicture>& pictures) {
  const auto name = to.CreateString(show.name);
  const auto topology = Write(to, show.cast.topology);
  const auto net = Write(to, show.cast.net);
  const auto faces = WriteAll(to, show.cast.faces);
  const auto expressions = WriteAll(to, show.cast.expressions);
  const auto props = WriteAll(to, show.cast.props);
  const auto textures = WriteAll(to, show.cast.textures);
  std::vector<pack::Call> calls = StoredCalls(show.buttons);
  std::ranges::copy(StoredCalls(show.second_buttons), std::back_inserter(calls));
  const auto buttons = to.CreateVectorOfStructs(calls);
  std::vector<pack::KeyCall> key_calls;
  for (const KeyCall& key : show.keys) key_calls.emplace_back(key.key_usage, StoredCall(key.call));
  const auto keys = to.CreateVectorOfStructs(key_calls);
  const auto motions = WriteAll(to, show.motions);
  const auto scenes = WriteAll(to, show.scenes);
  const auto brow_up = to.CreateVector(show.channels.brow_up.data(), show.channels.brow_up.size());
  const auto mouth = to.CreateVector(show.channels.mouth.data(), show.channels.mouth.size());
  const auto blink = to.CreateVector(show.cast.blink.data(), show.cast.blink.size());
  const auto cue_list = WriteCueList(to, show.cue_list);
  const auto roles = WriteRoles(to, show.roles);
  const auto gaze_targets = WriteAll(to, show.gaze_targets);
  const auto face_fades = Structs<pack::ItemFade>(to, show.face_fades);
  const auto expression_fades = Structs<pack::ItemFade>(to, show.expression_fades);
  const auto lobby = WriteLobby(to, show.lobby);
  const auto stick_buttons = to.CreateVectorOfStructs(StoredCalls(show.stick_buttons));
  // Absent where there are none, so that such a show gives the same bytes as before.
  Offset<flatbuffers::Vector<Offset<pack::KeyPicture>>> key_pictures;
  if (!pictures.empty()) key_pictures = WriteAll(to, pictures);
  const pack::Vec3 neck = Vec(show.cast.neck_pivot);
  const pack::Vec3 anchor = Vec(show.cast.mouth_anchor);
  return pack::CreatePack(to, name, topology, net, faces, expressions, props, textures, &neck, &anchor,
                          buttons, motions, scenes, brow_up, show.channels.brow_frown, show.channels.lids_up,
                          show.channels.lids_down, mouth, blink, keys, cue_list, roles, gaze_targets,
                          face_fades, expression_fades, lobby, stick_buttons, key_pictures);
}

}  // namespace

// A copy, since the builder keeps the content at the end of a larger buffer.
std::vector<std::uint8_t> EncodeContent(const Show& show, const std::vector<KeyPicture>& keys) {
  FlatBufferBuilder to(kFirstGuessBytes);
  pack::FinishPackBuffer(to, Write(to, show, keys));
  return {to.GetBufferPointer(), to.GetBufferPointer() + to.GetSize()};
}

}  // namespace kaori::show
