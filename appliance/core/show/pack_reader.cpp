#include <algorithm>
#include <string>
#include <utility>

#include "appliance/core/show/pack_calls.h"
#include "appliance/core/show/pack_content.h"
#include "appliance/core/show/pack_copier.h"
#include "appliance/core/show/pack_cues.h"
#include "appliance/core/show/pack_layout.h"
#include "appliance/core/show/pack_lobby.h"
#include "appliance/core/show/pack_roles.h"

namespace kaori::show {
namespace {

// Bounds of the verifier against forged contents: a show of 16 faces and 60 expressions has some hundred
// tables, four deep.
constexpr flatbuffers::uoffset_t kMaxTables = 100'000;
constexpr flatbuffers::uoffset_t kMaxDepth = 16;

glm::vec3 Vec(const pack::Vec3* v) {
  return v == nullptr ? glm::vec3{} : glm::vec3(v->x(), v->y(), v->z());
}

// A table that is missing reads as an empty value, here and below; the checks of the cast then say what is
// wrong.
face::SparseRows ReadRows(Copier& from, const pack::SparseRows* rows) {
  if (rows == nullptr) return {};
  return {from.Numbers(rows->row_start()), from.Numbers(rows->column()), from.Numbers(rows->weight())};
}

face::FineMesh ReadFine(Copier& from, const pack::FineMesh* fine) {
  if (fine == nullptr) return {};
  return {.from_cage = ReadRows(from, fine->from_cage()),
          .attributes_from_cage = ReadRows(from, fine->attributes_from_cage()),
          .triangles = from.Structs<face::Triangle>(fine->triangles()),
          .texture = from.Structs<glm::vec2>(fine->texture()),
          .twin = from.Numbers(fine->twin())};
}

face::LidRig ReadLids(Copier& from, const pack::LidRig& rig) {
  return {.columns = rig.columns(),
          .rings = rig.rings(),
          .margin_ring = rig.margin_ring(),
          .upper = from.Numbers(rig.upper()),
          .lower = from.Numbers(rig.lower()),
          .follow_upper = from.Numbers(rig.follow_upper()),
          .follow_lower = from.Numbers(rig.follow_lower())};
}

// Fixed arrays (two lids, two eyes) take what is there and leave the rest at its default; more is left out.
face::Topology ReadTopology(Copier& from, const pack::Topology* stored) {
  if (stored == nullptr) return {};
  face::Topology topology{.vertex_count = stored->vertex_count(),
                          .moving_count = stored->moving_count(),
                          .uv = from.Structs<glm::vec2>(stored->uv()),
                          .texture = from.Structs<glm::vec2>(stored->texture()),
                          .triangles = from.Structs<face::Triangle>(stored->triangles()),
                          .wires = from.Structs<face::Line>(stored->wires()),
                          .twin = from.Numbers(stored->twin()),
                          .mouth_share = from.Numbers(stored->mouth_share()),
                          .lids = {},
                          .fine = ReadFine(from, stored->fine()),
                          .outgrowth = from.Numbers(stored->outgrowth())};
  const auto lids = from.Tables<face::LidRig>(stored->lids(), ReadLids);
  std::copy_n(lids.begin(), std::min(lids.size(), topology.lids.size()), topology.lids.begin());
  return topology;
}

// Names and positions are two arrays in the file. The shorter one counts.
face::ControlNet ReadNet(Copier& from, const pack::ControlNet* stored) {
  if (stored == nullptr) return {};
  face::ControlNet net{.points = {},
                       .to_cage = ReadRows(from, stored->to_cage()),
                       .surface = ReadRows(from, stored->surface())};
  const auto uvs = from.Structs<glm::vec2>(stored->uvs());
  const auto names = stored->names() == nullptr ? 0 : stored->names()->size();
  for (flatbuffers::uoffset_t i = 0; i < names && i < uvs.size(); ++i)
    net.points.push_back({from.Text(stored->names()->Get(i)), uvs[i]});
  return net;
}

// Structs that a pack of an earlier program has not leave the Face's own defaults; numbers
// then read as pack.fbs says.
face::Face ReadFace(Copier& from, const pack::Face& stored) {
  face::Face face;
  face.name = from.Text(stored.name());
  face.positions = from.Structs<glm::vec3>(stored.positions());
  face.occlusion = from.Numbers(stored.occlusion());
  const auto eyes = from.Structs<face::EyeBall>(stored.eyes());
  std::copy_n(eyes.begin(), std::min(eyes.size(), face.eyes.size()), face.eyes.begin());
  if (stored.eye_look() != nullptr) face.eye_look = AsHeld<pack::EyeLook, face::EyeLook>(*stored.eye_look());
  if (stored.eye_surface() != nullptr)
    face.eye_surface = AsHeld<pack::EyeSurface, face::EyeSurface>(*stored.eye_surface());
  if (stored.mouth() != nullptr) face.mouth = AsHeld<pack::MouthFit, face::MouthFit>(*stored.mouth());
  face.surface = {stored.softness(), stored.metal(), stored.texture(), Vec(stored.flat()),
                  stored.print(),    stored.folds(), stored.flush()};
  face.props = from.Numbers(stored.props());
  face.expression_gain = stored.expression_gain();
  face.outgrowth_kind = stored.outgrowth_kind();
  face.withdrawn = from.Structs<glm::vec3>(stored.withdrawn());
  face.hang_arms_m = from.Structs<glm::vec2>(stored.hang_arms_m());
  face.sparse = from.Structs<face::Triangle>(stored.sparse());
  return face;
}

// A kind that does not exist stays one, for the checks of the cast to refuse. Of props the
// same holds for their part.
face::Expression ReadExpression(Copier& from, const pack::Expression& stored) {
  return {.name = from.Text(stored.name()),
          .kind = static_cast<face::ExpressionKind>(Narrow<std::uint8_t>(stored.kind())),
          .displacement = from.Structs<glm::vec3>(stored.displacement()),
          .lids = {stored.lid_left(), stored.lid_right()},
          .pupil = stored.pupil(),
          .flush = stored.flush(),
          .residual = from.Structs<glm::vec3>(stored.residual())};
}

face::Prop ReadProp(Copier& from, const pack::Prop& stored) {
  return {.name = from.Text(stored.name()),
          .part = static_cast<face::Part>(Narrow<std::uint8_t>(stored.part())),
          .colour = Vec(stored.colour()),
          .vertices = from.Structs<face::PropVertex>(stored.vertices()),
          .triangles = from.Structs<face::Triangle>(stored.triangles())};
}

face::Texture ReadTexture(Copier& from, const pack::Texture& stored) {
  return {stored.width_px(), stored.height_px(), from.Texels(stored.rgba())};
}

KeyPicture ReadKeyPicture(Copier& from, const pack::KeyPicture& stored) {
  return {stored.key_px(), stored.call(), stored.is_lit(), from.Numbers(stored.file())};
}

// A number of channels that is none is refused by CheckShow, and by IsSound where sounds alone are read.
Sound ReadSound(Copier& from, const pack::Motion& stored) {
  return {static_cast<int>(Narrow<std::uint8_t>(stored.sound_channels())), from.Numbers(stored.sound())};
}

Motion ReadMotion(Copier& from, const pack::Motion& stored) {
  const auto curve = [](Copier& copier, const pack::MotionCurve& c) {
    return MotionCurve{static_cast<MotionTarget>(Narrow<std::uint8_t>(c.target())),
                       Narrow<std::uint16_t>(c.channel()), copier.Structs<MotionKey>(c.keys())};
  };
  return {.name = from.Text(stored.name()),
          .key_usage = Narrow<std::uint16_t>(stored.key_usage()),
          .curves = from.Tables<MotionCurve>(stored.curves(), curve),
          .sound = ReadSound(from, stored),
          .recorded = stored.recorded(),
          .loop_from_s = stored.loop_from_s(),
          .loop_to_s = stored.loop_to_s(),
          .layer = static_cast<MotionLayer>(Narrow<std::uint8_t>(stored.layer()))};
}

// A scene of a pack from before scenes had amounts of life lives as people do.
StageScene ReadScene(Copier& from, const pack::StageScene& stored) {
  return {
      .name = from.Text(stored.name()),
      .key_usage = Narrow<std::uint16_t>(stored.key_usage()),
      .face = Narrow<std::uint16_t>(stored.face()),
      .expression = Narrow<std::uint16_t>(stored.expression()),
      .style = static_cast<scene::Style>(Narrow<std::uint8_t>(stored.style())),
      .backdrop = {Vec(stored.backdrop_top()), Vec(stored.backdrop_bottom()),
                   static_cast<scene::BackdropKind>(Narrow<std::uint8_t>(stored.backdrop_kind())),
                   Vec(stored.backdrop_glow()), stored.backdrop_picture()},
      .exposure = stored.exposure(),
      .fade_s = stored.fade_s(),
      .life = stored.life() == nullptr ? kWholeLife : AsHeld<pack::LifeAmounts, LifeAmounts>(*stored.life()),
      .gaze = stored.gaze()};
}

// Roles that are missing stay -1; more than this program knows are left out.
Channels ReadChannels(Copier& from, const pack::Pack& stored) {
  Channels channels;
  const auto brows = from.Numbers(stored.brow_up());
  std::copy_n(brows.begin(), std::min(brows.size(), channels.brow_up.size()), channels.brow_up.begin());
  const auto mouth = from.Numbers(stored.mouth_shapes());
  std::copy_n(mouth.begin(), std::min(mouth.size(), channels.mouth.size()), channels.mouth.begin());
  channels.brow_frown = stored.brow_frown();
  channels.lids_up = stored.lids_up();
  channels.lids_down = stored.lids_down();
  return channels;
}

GazeTarget ReadTarget(Copier& from, const pack::GazeTarget& stored) {
  return {from.Text(stored.name()), Vec(stored.at_m())};
}

// One list holds the buttons of both sheets, the second behind the first; a pack that ends with the first
// leaves the second empty, and one of before stick buttons those. Counts are bounded, since a forged list may be as long as the file.
void ReadControls(const pack::Pack& stored, Show& show) {
  if (stored.buttons() != nullptr)
    for (flatbuffers::uoffset_t i = 0; i < stored.buttons()->size() && i < 2 * kButtonCount; ++i)
      (i < kButtonCount ? show.buttons[i] : show.second_buttons[i - kButtonCount]) =
          HeldCall(*stored.buttons()->Get(i));
  if (stored.stick_buttons() != nullptr)
    for (flatbuffers::uoffset_t i = 0; i < stored.stick_buttons()->size() && i < show.stick_buttons.size();
         ++i)
      show.stick_buttons[i] = HeldCall(*stored.stick_buttons()->Get(i));
  if (stored.keys() == nullptr) return;
  for (flatbuffers::uoffset_t i = 0; i < stored.keys()->size() && i < kKeyUsages; ++i) {
    const pack::KeyCall* key = stored.keys()->Get(i);
    show.keys.push_back({Narrow<std::uint16_t>(key->key_usage()), HeldCall(key->call())});
  }
}

// Whether an index means anything is not judged here: CheckShow sees the whole show.
Show Read(Copier& from, const pack::Pack& stored) {
  Show show;
  show.name = from.Text(stored.name());
  show.cast = {.topology = ReadTopology(from, stored.topology()),
               .net = ReadNet(from, stored.net()),
               .faces = from.Tables<face::Face>(stored.faces(), ReadFace),
               .expressions = from.Tables<face::Expression>(stored.expressions(), ReadExpression),
               .props = from.Tables<face::Prop>(stored.props(), ReadProp),
               .textures = from.Tables<face::Texture>(stored.textures(), ReadTexture),
               .neck_pivot = Vec(stored.neck_pivot()),
               .mouth_anchor = Vec(stored.mouth_anchor())};
  ReadControls(stored, show);
  show.face_fades = from.Structs<ItemFade>(stored.face_fades());
  show.expression_fades = from.Structs<ItemFade>(stored.expression_fades());
  show.motions = from.Tables<Motion>(stored.motions(), ReadMotion);
  show.scenes = from.Tables<StageScene>(stored.scenes(), ReadScene);
  show.channels = ReadChannels(from, stored);
  show.cue_list = ReadCueList(from, stored.cue_list());
  show.roles = ReadRoles(from, stored.roles());
  show.lobby = ReadLobby(from, stored.lobby());
  show.gaze_targets = from.Tables<GazeTarget>(stored.gaze_targets(), ReadTarget);
  const auto blink = from.Numbers(stored.blink());
  std::copy_n(blink.begin(), std::min(blink.size(), show.cast.blink.size()), show.cast.blink.begin());
  return show;
}

// FlatBuffers' verifier sees to it that every offset lies within the content, so that reading is safe for any
// bytes. It does not see that two tables share an array, which could make a small file unfold to gigabytes:
// the copier's budget does.
template <class Reader>
auto Decode(std::span<const std::uint8_t> content, std::shared_ptr<const void> keeper, Reader read)
    -> Result<decltype(read(std::declval<Copier&>(), std::declval<const pack::Pack&>()))> {
  flatbuffers::Verifier verifier(content.data(), content.size(), kMaxDepth, kMaxTables);
  if (!pack::VerifyPackBuffer(verifier)) return FailInput("is damaged: its tables do not hang together");
  Copier copier(content.size(), std::move(keeper));
  auto found = read(copier, *pack::GetPack(content.data()));
  if (copier.overdrawn()) return FailInput("is damaged: it unfolds to more than it holds");
  return found;
}

}  // namespace

Result<Show> DecodeContent(std::span<const std::uint8_t> content, std::shared_ptr<const void> keeper) {
  return Decode(content, std::move(keeper), Read);
}

// Bounds are looked at after the copy, which is never larger than the content.
Result<std::vector<KeyPicture>> DecodeKeys(std::span<const std::uint8_t> content) {
  auto keys = Decode(content, nullptr, [](Copier& from, const pack::Pack& stored) {
    return from.Tables<KeyPicture>(stored.key_pictures(), ReadKeyPicture);
  });
  std::size_t bytes = 0;
  bool fits = !keys || keys->size() <= kMostKeyPictures;
  for (const KeyPicture& key : keys.value_or(std::vector<KeyPicture>{})) {
    fits &= key.file.size() <= kMostKeyPicture_bytes;
    bytes += key.file.size();
  }
  if (!fits || bytes > kMostKeyPictures_bytes)
    return FailInput("has too many pictures of keys, or too large ones");
  return keys;
}

Result<std::vector<Sound>> DecodeSounds(std::span<const std::uint8_t> content) {
  return Decode(content, nullptr, [](Copier& from, const pack::Pack& stored) {
    return from.Tables<Sound>(stored.motions(), ReadSound);
  });
}

}  // namespace kaori::show
