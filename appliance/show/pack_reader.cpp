#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>

#include "appliance/show/check.h"
#include "appliance/show/pack.h"
#include "appliance/show/pack_layout.h"
#include "drivers/base/unique_fd.h"

namespace kaori::show {
namespace {

constexpr flatbuffers::uoffset_t kMaxTables = 100'000;
constexpr flatbuffers::uoffset_t kMaxDepth = 16;

// A whole file, mapped for reading.
class Mapping {
 public:
  Mapping(void* at, std::size_t bytes) : at_(at), bytes_(bytes) {}
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  Mapping(Mapping&& other) noexcept : at_(std::exchange(other.at_, nullptr)), bytes_(other.bytes_) {}
  Mapping& operator=(Mapping&&) = delete;
  ~Mapping() {
    if (at_ != nullptr) ::munmap(at_, bytes_);
  }
  const std::uint8_t* data() const { return static_cast<const std::uint8_t*>(at_); }
  std::size_t size() const { return bytes_; }

 private:
  void* at_;
  std::size_t bytes_;
};

Result<Mapping> Map(const std::string& name) {
  const UniqueFd fd(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.valid()) return FailErrno("open the show " + name);
  struct stat status {};
  if (::fstat(fd.get(), &status) < 0) return FailErrno("look at the show " + name);
  if (status.st_size == 0) return FailInput("the show " + name + " is empty");
  const auto bytes = static_cast<std::size_t>(status.st_size);
  void* at = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd.get(), 0);
  if (at == MAP_FAILED) return FailErrno("map the show " + name);
  return Mapping(at, bytes);
}

// Absent vectors read as empty: CheckShow then says what is missing.
template <class Held, class Stored>
std::vector<Held> Structs(const flatbuffers::Vector<const Stored*>* stored) {
  SameBytes<Stored, Held>();
  std::vector<Held> held(stored == nullptr ? 0 : stored->size());
  if (!held.empty()) std::memcpy(held.data(), stored->Data(), held.size() * sizeof(Held));
  return held;
}

template <class T>
std::vector<T> Numbers(const flatbuffers::Vector<T>* stored) {
  if (stored == nullptr) return {};
  return {stored->data(), stored->data() + stored->size()};
}

std::string Text(const flatbuffers::String* stored) { return stored == nullptr ? std::string() : stored->str(); }

glm::vec3 Vec(const pack::Vec3* v) { return v == nullptr ? glm::vec3{} : glm::vec3(v->x(), v->y(), v->z()); }

template <class To, class Stored, class Read>
std::vector<To> Tables(const flatbuffers::Vector<flatbuffers::Offset<Stored>>* stored, Read read) {
  std::vector<To> all;
  if (stored == nullptr) return all;
  for (const Stored* one : *stored) all.push_back(read(*one));
  return all;
}

face::SparseRows ReadRows(const pack::SparseRows* rows) {
  if (rows == nullptr) return {};
  return {Numbers(rows->row_start()), Numbers(rows->column()), Numbers(rows->weight())};
}

face::FineMesh ReadFine(const pack::FineMesh* fine) {
  if (fine == nullptr) return {};
  return {.from_cage = ReadRows(fine->from_cage()),
          .attributes_from_cage = ReadRows(fine->attributes_from_cage()),
          .triangles = Structs<face::Triangle>(fine->triangles()),
          .texture = Structs<glm::vec2>(fine->texture()),
          .twin = Numbers(fine->twin())};
}

face::LidRig ReadLids(const pack::LidRig& rig) {
  return {.columns = rig.columns(),
          .rings = rig.rings(),
          .margin_ring = rig.margin_ring(),
          .upper = Numbers(rig.upper()),
          .lower = Numbers(rig.lower()),
          .follow_upper = Numbers(rig.follow_upper()),
          .follow_lower = Numbers(rig.follow_lower())};
}

face::Topology ReadTopology(const pack::Topology* stored) {
  if (stored == nullptr) return {};
  face::Topology topology{.vertex_count = stored->vertex_count(),
                          .moving_count = stored->moving_count(),
                          .place = Structs<glm::vec2>(stored->place()),
                          .texture = Structs<glm::vec2>(stored->texture()),
                          .triangles = Structs<face::Triangle>(stored->triangles()),
                          .wires = Structs<face::Line>(stored->wires()),
                          .twin = Numbers(stored->twin()),
                          .mouth_share = Numbers(stored->mouth_share()),
                          .lids = {},
                          .fine = ReadFine(stored->fine())};
  const auto lids = Tables<face::LidRig>(stored->lids(), ReadLids);
  std::copy_n(lids.begin(), std::min(lids.size(), topology.lids.size()), topology.lids.begin());
  return topology;
}

face::ControlNet ReadNet(const pack::ControlNet* stored) {
  if (stored == nullptr) return {};
  face::ControlNet net{.points = {},
                       .to_cage = ReadRows(stored->to_cage()),
                       .to_cage_linear = ReadRows(stored->to_cage_linear()),
                       .surface = ReadRows(stored->surface())};
  const auto places = Structs<glm::vec2>(stored->places());
  const auto names = stored->names() == nullptr ? 0 : stored->names()->size();
  for (flatbuffers::uoffset_t i = 0; i < names && i < places.size(); ++i)
    net.points.push_back({Text(stored->names()->Get(i)), places[i]});
  return net;
}

face::Face ReadFace(const pack::Face& stored) {
  face::Face face;
  face.name = Text(stored.name());
  face.positions = Structs<glm::vec3>(stored.positions());
  face.occlusion = Numbers(stored.occlusion());
  const auto eyes = Structs<face::EyeBall>(stored.eyes());
  std::copy_n(eyes.begin(), std::min(eyes.size(), face.eyes.size()), face.eyes.begin());
  if (stored.eye_look() != nullptr) face.eye_look = AsHeld<pack::EyeLook, face::EyeLook>(*stored.eye_look());
  if (stored.mouth() != nullptr) face.mouth = AsHeld<pack::MouthFit, face::MouthFit>(*stored.mouth());
  face.surface = {stored.softness(), stored.metal(), stored.texture(), Vec(stored.flat())};
  face.props = Numbers(stored.props());
  face.expression_gain = stored.expression_gain();
  return face;
}

face::Expression ReadExpression(const pack::Expression& stored) {
  return {.name = Text(stored.name()),
          .kind = static_cast<face::ExpressionKind>(stored.kind()),
          .displacement = Structs<glm::vec3>(stored.displacement()),
          .lids = {stored.lid_left(), stored.lid_right()}};
}

face::Prop ReadProp(const pack::Prop& stored) {
  return {.name = Text(stored.name()),
          .part = static_cast<face::Part>(stored.part()),
          .colour = Vec(stored.colour()),
          .vertices = Structs<face::PropVertex>(stored.vertices()),
          .triangles = Structs<face::Triangle>(stored.triangles())};
}

face::Texture ReadTexture(const pack::Texture& stored) {
  return {stored.width_px(), stored.height_px(), Numbers(stored.rgba())};
}

Take ReadTake(const pack::Take& stored) {
  const auto curve = [](const pack::TakeCurve& c) {
    return TakeCurve{static_cast<TakeTarget>(c.target()), static_cast<std::uint16_t>(c.channel()),
                     Structs<TakeKey>(c.keys())};
  };
  return {Text(stored.name()), static_cast<std::uint16_t>(stored.key_usage()),
          Tables<TakeCurve>(stored.curves(), curve)};
}

StageScene ReadScene(const pack::StageScene& stored) {
  return {.name = Text(stored.name()),
          .key_usage = static_cast<std::uint16_t>(stored.key_usage()),
          .face = static_cast<std::uint16_t>(stored.face()),
          .expression = static_cast<std::uint16_t>(stored.expression()),
          .style = static_cast<scene::Style>(stored.style()),
          .backdrop = {Vec(stored.backdrop_top()), Vec(stored.backdrop_bottom())},
          .exposure = stored.exposure(),
          .fade_s = stored.fade_s()};
}

Channels ReadChannels(const pack::Pack& stored) {
  Channels channels;
  const auto brows = Numbers(stored.brow_up());
  std::copy_n(brows.begin(), std::min(brows.size(), channels.brow_up.size()), channels.brow_up.begin());
  const auto mouth = Numbers(stored.mouth_shapes());
  std::copy_n(mouth.begin(), std::min(mouth.size(), channels.mouth.size()), channels.mouth.begin());
  channels.brow_frown = stored.brow_frown();
  channels.lids_up = stored.lids_up();
  channels.lids_down = stored.lids_down();
  return channels;
}

Show Read(const pack::Pack& stored) {
  Show show;
  show.name = Text(stored.name());
  show.cast = {.topology = ReadTopology(stored.topology()),
               .net = ReadNet(stored.net()),
               .faces = Tables<face::Face>(stored.faces(), ReadFace),
               .expressions = Tables<face::Expression>(stored.expressions(), ReadExpression),
               .props = Tables<face::Prop>(stored.props(), ReadProp),
               .textures = Tables<face::Texture>(stored.textures(), ReadTexture),
               .neck_pivot = Vec(stored.neck_pivot()),
               .mouth_anchor = Vec(stored.mouth_anchor())};
  if (stored.buttons() != nullptr)
    for (flatbuffers::uoffset_t i = 0; i < stored.buttons()->size() && i < show.buttons.size(); ++i) {
      const pack::Call* call = stored.buttons()->Get(i);
      show.buttons[i] = {static_cast<CallKind>(call->kind()), static_cast<std::uint16_t>(call->index())};
    }
  show.takes = Tables<Take>(stored.takes(), ReadTake);
  show.scenes = Tables<StageScene>(stored.scenes(), ReadScene);
  show.channels = ReadChannels(stored);
  return show;
}

}  // namespace

Result<Show> LoadPack(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto mapping = Map(name);
  if (!mapping) return tl::unexpected(mapping.error());
  flatbuffers::Verifier verifier(mapping->data(), mapping->size(), kMaxDepth, kMaxTables);
  if (!pack::VerifyPackBuffer(verifier)) return FailInput(name + " is no whole show pack");
  const pack::Pack* stored = pack::GetPack(mapping->data());
  if (stored->version() != kPackVersion)
    return FailInput(name + " is a show pack of version " + std::to_string(stored->version()) +
                     "; this box plays version " + std::to_string(kPackVersion));
  Show show = Read(*stored);
  if (const auto faults = CheckShow(show); !faults.empty())
    return FailInput(name + ": " + faults.front() +
                     (faults.size() > 1 ? " (and " + std::to_string(faults.size() - 1) + " more faults)" : ""));
  return show;
}

}  // namespace kaori::show
