#include "appliance/authoring/pack/facts.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/show/pack.h"
#include "drivers/base/clock.h"

namespace kaori::authoring {
namespace {

// More would run off the screen, and a bad cast has thousands.
constexpr std::size_t kFindingsShown = 20;

// Two digits a byte, as public keys are shown to people.
std::string Hex(const show::PublicKey& key) {
  return fmt::format("{:02x}", fmt::join(key.bytes, ""));
}

// The order is that of the pack.
template <class Items>
std::vector<std::string> NamesOf(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

// One list of the cast holds all three kinds, since all of them are displacements of the same control net.
std::vector<std::string> NamesOfKind(const face::Cast& cast, face::ExpressionKind kind) {
  std::vector<std::string> names;
  for (const face::Expression& e : cast.expressions)
    if (e.kind == kind) names.push_back(e.name);
  return names;
}

// Every face of a cast shares one topology, so that these counts hold for each of them.
void CountCast(const face::Cast& cast, Facts& facts) {
  const auto& topology = cast.topology;
  facts.triangles_of_cage = topology.triangles.size();
  facts.triangles_on_face =
      // A cast that was made of a dense mesh may have no fine one.
      topology.fine.triangles.empty() ? topology.triangles.size() : topology.fine.triangles.size();
  facts.vertices_of_cage = topology.vertex_count;
  facts.control_points = cast.net.points.size();
  facts.faces = NamesOf(cast.faces);
  facts.expressions = NamesOfKind(cast, face::ExpressionKind::kExpression);
  facts.mouth_shapes = NamesOfKind(cast, face::ExpressionKind::kMouth);
  facts.channels = NamesOfKind(cast, face::ExpressionKind::kChannel);
  facts.props = cast.props.size();
  for (const face::Prop& prop : cast.props) facts.triangles_of_props += prop.triangles.size();
  facts.textures = cast.textures.size();
}

// A busy neighbour is no property of a pack: the quickest of a few loads counts. The last one's show is kept.
Result<show::Show> LoadTimed(const std::filesystem::path& file, double& quickest_ms) {
  constexpr int kLoads = 3;
  const SteadyClock clock;
  quickest_ms = std::numeric_limits<double>::max();
  // The first load that fails ends the loop: a file that cannot be read once is not tried again.
  for (int i = 1;; ++i) {
    const Time begun = clock.now();
    auto show = show::LoadPack(file);
    quickest_ms = std::min(quickest_ms, Seconds(clock.now() - begun) * 1e3);
    if (!show || i == kLoads) return show;
  }
}

// A line of the page: item and value in two columns.
// The width of 18 is that of the longest item, "teeth through lips".
std::string Row(std::string_view item, const std::string& says) {
  return fmt::format("{:<18} {}\n", item, says);
}

// The count comes first, in a column of 4, so that lists of different lengths can be compared at a glance.
std::string Listed(const std::vector<std::string>& names) {
  return fmt::format("{:<4} {}", names.size(), fmt::join(names, " "));
}

}  // namespace

// The header alone is read first: it costs nothing, and a file that is no pack is refused
// before anything is timed.
Result<Facts> GatherFacts(const std::filesystem::path& file,
                          const std::function<void(const std::string&)>& progress) {
  Facts facts;
  const auto signer = show::ReadSigner(file);
  if (!signer) return tl::unexpected(signer.error());
  if (*signer) facts.signed_by = Hex(**signer);
  const auto show = LoadTimed(file, facts.load_ms);
  if (!show) return tl::unexpected(show.error());
  std::error_code unknown;
  // A file that vanished after it was loaded has 0 bytes here: that is no reason to lose all other facts.
  const auto bytes = std::filesystem::file_size(file, unknown);
  facts.file_bytes = unknown ? 0 : bytes;
  facts.show = show->name;
  facts.motions = show->motions.size();
  facts.scenes = show->scenes.size();
  CountCast(show->cast, facts);
  facts.looks =
      inspect::Inspect(show->cast, [&](const std::string& face) { progress("looking at " + face); });
  return facts;
}

// Megabytes are of 10^6 bytes. Findings come last, since they may be many.
std::string FactsPage(const Facts& f) {
  std::string page = Row("show", f.show);
  page += Row("file", fmt::format("{:.1f} MB, {}", static_cast<double>(f.file_bytes) * 1e-6,
                                  f.signed_by.empty() ? "not signed" : "signed by " + f.signed_by));
  page += Row("loads in", fmt::format("{:.0f} ms", f.load_ms));
  page += Row("triangles", fmt::format("{} on each face; cage {}, with {} vertices", f.triangles_on_face,
                                       f.triangles_of_cage, f.vertices_of_cage));
  page += Row("control points", fmt::format("{}", f.control_points));
  page += Row("faces", Listed(f.faces)) + Row("expressions", Listed(f.expressions));
  page += Row("mouth shapes", Listed(f.mouth_shapes)) + Row("channels", Listed(f.channels));
  page += Row("props", fmt::format("{:<4} {} triangles", f.props, f.triangles_of_props));
  page += Row("textures", fmt::format("{}", f.textures));
  page += Row("motions", fmt::format("{}", f.motions)) + Row("scenes", fmt::format("{}", f.scenes));
  page +=
      Row("folds", fmt::format("{}", f.looks.folds)) + Row("lid gaps", fmt::format("{}", f.looks.lid_gaps));
  page += Row("teeth through lips", fmt::format("{}", f.looks.teeth_through_lips));
  const auto& findings = f.looks.findings;
  for (std::size_t i = 0; i < findings.size() && i < kFindingsShown; ++i)
    page += "  " + Say(findings[i]) + "\n";
  if (findings.size() > kFindingsShown)
    page += fmt::format("  and {} more; --json lists them all\n", findings.size() - kFindingsShown);
  return page;
}

}  // namespace kaori::authoring
