#include "render/face/composer.h"

#include <algorithm>
#include <vector>

#include "render/face/aligned.h"
#include "render/face/blend.h"
#include "render/face/composites.h"
#include "render/face/eyelids.h"
#include "render/face/fine_lid.h"
#include "render/face/mix.h"
#include "render/face/normals.h"
#include "render/face/sparse.h"

namespace kaori::face {
namespace {

// Lists are sized for all the terms that weights can have, so that no frame allocates.
constexpr std::size_t kTerms = Terms::kCapacity;

// A stream of each face's occlusion; an empty one is open everywhere.
AlignedFloats OcclusionOfFaces(const Cast& cast, std::size_t stride) {
  AlignedFloats all(cast.faces.size() * stride);
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    float* out = all.data() + i * stride;
    const auto& occlusion = cast.faces[i].occlusion;
    if (occlusion.empty()) std::fill_n(out, stride, 1.0F);
    std::ranges::copy(occlusion, out);
  }
  return all;
}

// Where the lids have no rings to shut them by, expressions of their own do it.
void BlinkByExpression(const Cast& cast, Weights& weights) {
  const auto shut = MixLids(cast.expressions, weights);
  for (std::size_t side = 0; side < 2; ++side) {
    if (cast.topology.lids[side].columns > 0 || cast.blink[side] < 0 || !(shut[side] > 0)) continue;
    weights.channels.Push(static_cast<std::uint16_t>(cast.blink[side]), shut[side]);
  }
}

// The mouth's share of each vertex, three times over: once for each float of a stream.
AlignedFloats MouthShareOfFloats(const Topology& topology, std::size_t floats) {
  AlignedFloats share(floats);
  if (topology.mouth_share.empty()) return share;
  for (std::size_t i = 0; i < 3 * std::size_t{topology.moving_count}; ++i) {
    share.data()[i] = topology.mouth_share[i / 3];
  }
  return share;
}

}  // namespace

// Everything that Compose reads and writes besides the cast. Its sizes are fixed at construction.
struct Composer::Work {
  explicit Work(const Cast& cast);

  // Brings the composites up to date that this frame uses.
  void Refresh(const Cast& cast, const Weights& weights);
  // Lists the terms of the sum.
  void Gather(const Weights& weights);
  void GatherFace(const Term& face, const Weights& weights);
  // The sum itself, into `cage`.
  void BlendCage(float mouth_given_away);
  // Outgrowths of faces that are not of one kind go back into the head, in `cage`. Returns how far, 0 to 1.
  float Withdraw(const Cast& cast, const Terms& faces);
  // What hangs from the head swings, in `cage`, as far as it is not withdrawn.
  void Hang(const Cast& cast, const Weights& weights, float withdrawn);
  // From the cage, with lids in place, to the fine mesh.
  void Refine(const Shape& of);
  void ComputeNormals(Detail detail);
  void BlendOcclusion(const Terms& faces);
  void RefineOcclusion();
  Shape View(const Topology& topology, Detail detail) const;

  Composites composites;
  const FineMesh& mesh;
  SurfaceNormals cage_surface;
  SurfaceNormals fine_surface;
  std::array<FineLid, 2> fine_lids;
  AlignedFloats mouth_share;
  std::size_t occlusion_floats;
  AlignedFloats face_occlusion;

  std::vector<Stream> bases;       // s_i B_i.
  std::vector<Stream> unyielding;  // The same, and s_i c_k A_ik.
  std::vector<Stream> yielding;    // s_i t_j E_ij.
  AlignedFloats cage, cage_normals, fine, fine_normals, occlusion, fine_occlusion;
  Terms occlusion_of;                 // The faces whose occlusion was blended last;
  bool fine_occlusion_holds = false;  // and whether the fine mesh has it.
};

Composer::Work::Work(const Cast& cast)
    : composites(cast),
      mesh(cast.topology.fine),
      cage_surface(cast.topology.triangles, cast.topology.twin, cast.topology.wires),
      fine_surface(mesh.triangles, mesh.twin, {}),
      fine_lids{FineLid(cast.topology.lids[0], mesh), FineLid(cast.topology.lids[1], mesh)},
      mouth_share(MouthShareOfFloats(cast.topology, composites.moving_floats())),
      occlusion_floats(Padded(cast.topology.vertex_count)),
      face_occlusion(OcclusionOfFaces(cast, occlusion_floats)),
      cage(composites.face_floats()),
      cage_normals(composites.face_floats()),
      fine(3 * mesh.from_cage.rows()),
      fine_normals(3 * mesh.from_cage.rows()),
      occlusion(occlusion_floats),
      fine_occlusion(mesh.from_cage.rows()) {
  bases.reserve(kTerms);
  unyielding.reserve(kTerms + kTerms * kTerms);
  yielding.reserve(kTerms * kTerms);
}

// Only what has weight: an expression in work is composed on a face when that face is shown.
void Composer::Work::Refresh(const Cast& cast, const Weights& weights) {
  for (const Term& face : weights.faces) {
    for (const Term& term : weights.expressions) composites.Refresh(cast, face.index, term.index);
    for (const Term& term : weights.channels) composites.Refresh(cast, face.index, term.index);
  }
}

void Composer::Work::Gather(const Weights& weights) {
  bases.clear();
  unyielding.clear();
  yielding.clear();
  for (const Term& face : weights.faces) GatherFace(face, weights);
}

// The weight of a composite is the product of its face's and its expression's weight: equation 1, multiplied
// out.
void Composer::Work::GatherFace(const Term& face, const Weights& weights) {
  const auto add = [&](const Terms& terms, std::vector<Stream>& streams) {
    for (const Term& term : terms) {
      const float* values = composites.displacement(face.index, term.index);
      if (values != nullptr) streams.push_back({values, face.weight * term.weight});
    }
  };
  bases.push_back({composites.base(face.index), face.weight});
  unyielding.push_back(bases.back());
  add(weights.channels, unyielding);
  add(weights.expressions, weights.mouth_given_away > 0 ? yielding : unyielding);
}

// The part that moves with expressions, then the rest, where only faces differ.
void Composer::Work::BlendCage(float mouth_given_away) {
  const std::size_t moving = composites.moving_floats();
  Blend(unyielding, {yielding, mouth_share.data(), mouth_given_away}, moving, cage.data());
  // The first part ends with a cache line and so holds some floats of vertices that do not move:
  // displacements are zero there.
  for (Stream& base : bases) base.values += moving;
  Blend(bases, composites.face_floats() - moving, cage.data() + moving);
}

// Wholly from a quarter on: what grew out of the one head is gone before what grows out of the other is seen.
// Nothing happens to faces of one kind, whatever their weights.
float Composer::Work::Withdraw(const Cast& cast, const Terms& faces) {
  float kind = 0;
  for (const Term& t : faces) kind += t.weight * cast.faces[t.index].outgrowth_kind;
  const float mixed = 4 * kind * (1 - kind);
  if (!(mixed > 0)) return 0;
  const float gone = 1 - (1 - mixed) * (1 - mixed);
  const auto& vertices = cast.topology.outgrowth;
  const auto positions = cage.vertices(cast.topology.vertex_count);
  for (const Term& t : faces) {
    const auto& ways = cast.faces[t.index].withdrawn;
    for (std::size_t i = 0; i < ways.size(); ++i) positions[vertices[i]] += t.weight * gone * ways[i];
  }
  return gone;
}

// Few vertices, and of few faces: for the others nothing is done. The side is that of the face at rest.
void Composer::Work::Hang(const Cast& cast, const Weights& weights, float withdrawn) {
  const auto& vertices = cast.topology.outgrowth;
  const auto positions = cage.vertices(cast.topology.vertex_count);
  for (const Term& t : weights.faces) {
    const Face& face = cast.faces[t.index];
    for (std::size_t i = 0; i < face.hang_arms_m.size(); ++i) {
      const Hanging& side = weights.hanging[face.positions[vertices[i]].x < 0 ? 1 : 0];
      const glm::vec2 by_m = (t.weight * (1 - withdrawn)) * (face.hang_arms_m[i].x * side.upper_rad +
                                                             face.hang_arms_m[i].y * side.lower_rad);
      positions[vertices[i]] += glm::vec3(by_m.x, 0, by_m.y);
    }
  }
}

// The fine mesh smooths lids off the ball's curve, so they are fitted once more.
void Composer::Work::Refine(const Shape& of) {
  ApplyToVertices(mesh.from_cage, cage.data(), fine.data());
  for (std::size_t side = 0; side < 2; ++side) {
    fine_lids[side].Fit(of.eyes[side], of.lids_shut[side], fine.vertices(mesh.from_cage.rows()));
  }
}

// The cage's normals are needed in every style: handles stand by them.
void Composer::Work::ComputeNormals(Detail detail) {
  cage_surface.Compute(cage.data(), cage_normals.data());
  if (detail == Detail::kCage) return;
  fine_surface.Compute(fine.data(), fine_normals.data());
}

// Occlusion depends on the faces alone, so it is kept until their weights change.
void Composer::Work::BlendOcclusion(const Terms& faces) {
  // Exactly equal: a fade changes them in every frame, a face at rest in none.
  if (faces == occlusion_of) return;
  bases.clear();
  for (const Term& t : faces) bases.push_back({face_occlusion.data() + t.index * occlusion_floats, t.weight});
  Blend(bases, occlusion_floats, occlusion.data());
  occlusion_of = faces;
  fine_occlusion_holds = false;
}

void Composer::Work::RefineOcclusion() {
  if (fine_occlusion_holds) return;
  ApplyToValues(mesh.attributes_from_cage, occlusion.data(), fine_occlusion.data());
  fine_occlusion_holds = true;
}

// The arrays without their slack, as spans.
Shape Composer::Work::View(const Topology& topology, Detail detail) const {
  const std::size_t vertices = topology.vertex_count;
  const std::size_t fine_vertices = detail == Detail::kFine ? mesh.from_cage.rows() : 0;
  Shape shape;
  shape.cage = cage.vertices(vertices);
  shape.cage_normals = cage_normals.vertices(vertices);
  shape.occlusion = {occlusion.data(), vertices};
  shape.fine = fine.vertices(fine_vertices);
  shape.fine_normals = fine_normals.vertices(fine_vertices);
  shape.fine_occlusion = {fine_occlusion.data(), fine_vertices};
  return shape;
}

Composer::Composer(const Cast& cast) : cast_(cast), work_(std::make_unique<Work>(cast)) {}
Composer::~Composer() = default;
Composer::Composer(Composer&&) noexcept = default;

void Composer::Renew(std::size_t expression) {
  work_->composites.Outdate(cast_, expression);
}

// The order: weights, sum, occlusion, the few numbers of a face, lids, fine mesh, normals.
const Shape& Composer::Compose(const Weights& weights, Detail detail) {
  // From here on indices exist and faces sum to 1.
  Weights playable = Playable(weights, cast_.faces.size(), cast_.expressions.size());
  BlinkByExpression(cast_, playable);
  const Topology& topology = cast_.topology;
  work_->Refresh(cast_, playable);
  work_->Gather(playable);
  work_->BlendCage(playable.mouth_given_away);
  const float withdrawn = work_->Withdraw(cast_, playable.faces);
  work_->Hang(cast_, playable, withdrawn);
  work_->BlendOcclusion(playable.faces);
  if (detail == Detail::kFine) work_->RefineOcclusion();

  shape_ = work_->View(topology, detail);
  shape_.faces = playable.faces;
  shape_.eyes = MixEyes(cast_.faces, playable);
  shape_.eye_look = MixEyeLook(cast_.faces, playable);
  shape_.eye_surface = MixEyeSurface(cast_.faces, cast_.expressions, playable);
  shape_.flush = MixFlush(cast_.faces, cast_.expressions, playable);
  shape_.mouth = MixMouth(cast_.faces, playable);
  shape_.lids_shut = MixLids(cast_.expressions, playable);
  shape_.jaw_drop_m = MixJawDrop(work_->composites, playable);

  // Lids are shut on the blended face, whose eyeball is blended too, then kept off the ball; normals come
  // last of all.
  const auto cage = work_->cage.vertices(topology.vertex_count);
  for (std::size_t side = 0; side < 2; ++side) {
    ShutLids(topology.lids[side], shape_.lids_shut[side], cage);
    FitLids(topology.lids[side], shape_.eyes[side], cage);
  }
  if (detail == Detail::kFine) work_->Refine(shape_);
  work_->ComputeNormals(detail);
  return shape_;
}

}  // namespace kaori::face
