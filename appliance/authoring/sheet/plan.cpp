#include "appliance/authoring/sheet/plan.h"
#include "render/scene/scene.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace kaori::authoring {
namespace {

using face::ExpressionKind;

// On the sheet of one face: cells of the usual 320 px make a picture of some 2600 px.
constexpr int kInARow = 8;
constexpr float kClose_m = 0.78F;  // Near enough to see a lip, far enough for hair and ears.
// A little to the side: straight ahead, depth cannot be judged.
constexpr float kTurned_rad = 0.2F;

// A side and the camera's yaw towards it; the names are the character's own sides.
struct Side {
  const char* name;
  float yaw_rad;
};
constexpr std::array<Side, 5> kSides{
    {{"right", -1.3F}, {"half right", -0.6F}, {"front", 0}, {"half left", 0.6F}, {"left", 1.3F}}};

// How far lids are shut, left and right, as an operator or the box shuts them.
struct Lids {
  const char* name;
  std::array<float, 2> shut;
};
constexpr std::array<Lids, 6> kLids{{{"a quarter", {0.25F, 0.25F}},
                                     {"half", {0.5F, 0.5F}},
                                     {"three quarters", {0.75F, 0.75F}},
                                     {Flaws::kLidsShut, {1, 1}},
                                     {"wink left", {1, 0}},
                                     {"wink right", {0, 1}}}};

// A face at rest, at the usual distance. Expression 0 is "neutral".
scene::Scene Portrait(std::uint16_t face) {
  scene::Scene scene;
  scene.weights.faces.Push(face, 1);
  scene.weights.expressions.Push(0, 1);
  return scene;
}

// Close, with the expression whole; mouth shapes and channels come on top of the face at rest.
scene::Scene Wearing(const face::Cast& cast, std::uint16_t face, std::uint16_t expression) {
  scene::Scene scene = Portrait(face);
  scene.camera.distance_m = kClose_m;
  scene.head.yaw_rad = kTurned_rad;
  if (cast.expressions[expression].kind == ExpressionKind::kExpression) {
    scene.weights.expressions.clear();
    scene.weights.expressions.Push(expression, 1);
  } else {
    scene.weights.channels.Push(expression, 1);
  }
  return scene;
}

// In the cast's order.
std::vector<std::uint16_t> OfKind(const face::Cast& cast, ExpressionKind kind) {
  std::vector<std::uint16_t> indices;
  for (std::uint16_t e = 0; e < cast.expressions.size(); ++e)
    if (cast.expressions[e].kind == kind) indices.push_back(e);
  return indices;
}

// From the face `first` on: the sheet of morphs has no row for the face that all others come from.
std::vector<std::string> FaceNames(const face::Cast& cast, std::size_t first = 0) {
  std::vector<std::string> names;
  for (std::size_t i = first; i < cast.faces.size(); ++i) names.push_back(cast.faces[i].name);
  return names;
}

// One function for each sheet. Borrows show and flaws.
class Planner {
 public:
  Planner(const show::Show& show, const Flaws& flaws) : show_(show), cast_(show.cast), flaws_(flaws) {}

  // The most telling sheet, at half size: flaws of all faces at a glance.
  Sheet WholeCast() const {
    const auto expressions = OfKind(cast_, ExpressionKind::kExpression);
    Section grid{.in_a_row = static_cast<int>(expressions.size()), .rows = FaceNames(cast_)};
    for (const std::uint16_t e : expressions) grid.columns.push_back(cast_.expressions[e].name);
    for (std::uint16_t f = 0; f < cast_.faces.size(); ++f)
      for (const std::uint16_t e : expressions) grid.cells.push_back(Worn(f, e));
    Sheet sheet = Titled("cast.png", show_.name + ": every face with every expression");
    sheet.about = fmt::format("{}; {}", CountsOf(cast_), flaws_.summary());
    sheet.is_flawed = flaws_.any();
    // The whole cast has some hundreds of cells; at full size the picture would be too large to look at.
    sheet.size = 0.5F;
    sheet.sections = {std::move(grid)};
    return sheet;
  }

  Sheet Sides() const {
    Section grid{.in_a_row = static_cast<int>(kSides.size()), .rows = FaceNames(cast_)};
    for (const Side& side : kSides) grid.columns.emplace_back(side.name);
    for (std::uint16_t f = 0; f < cast_.faces.size(); ++f)
      // The camera goes round; the head stays, so that the light stays on it.
      for (const Side& side : kSides) {
        grid.cells.push_back(Plain(f, side.name));
        grid.cells.back().scene.camera.yaw_rad = side.yaw_rad;
      }
    return Titled("faces.png", "The cast from five sides", std::move(grid));
  }

  // Each style alone and whole. The head is turned a little: straight ahead, depth cannot be judged.
  Sheet Styles() const {
    Section grid{.in_a_row = scene::kStyleCount, .rows = FaceNames(cast_)};
    for (const char* style : scene::kStyleNames) grid.columns.emplace_back(style);
    for (std::uint16_t f = 0; f < cast_.faces.size(); ++f)
      for (std::size_t style = 0; style < scene::kStyleNames.size(); ++style) {
        grid.cells.push_back(Plain(f, scene::kStyleNames[style]));
        grid.cells.back().scene.styles = {};
        grid.cells.back().scene.styles[style] = 1;
        grid.cells.back().scene.head.yaw_rad = 0.35F;
      }
    return Titled("styles.png", "The ways of drawing", std::move(grid));
  }

  // From face 0 to each other one, by weights of 0 to 1 in four steps.
  Sheet Morphs() const {
    constexpr int kSteps = 5;
    Section grid{.in_a_row = kSteps, .rows = FaceNames(cast_, 1)};
    for (int step = 0; step < kSteps; ++step)
      grid.columns.push_back(fmt::format("{} %", 100 * step / (kSteps - 1)));
    for (std::uint16_t f = 1; f < cast_.faces.size(); ++f)
      for (int step = 0; step < kSteps; ++step) {
        const float share = static_cast<float>(step) / (kSteps - 1);
        grid.cells.push_back(Plain(f, grid.columns[static_cast<std::size_t>(step)]));
        scene::Scene& scene = grid.cells.back().scene;
        scene.weights.faces.clear();
        scene.weights.faces.Push(0, 1 - share);
        scene.weights.faces.Push(f, share);
        scene.head.yaw_rad = 0.3F;
      }
    return Titled("morphs.png", "From " + cast_.faces.front().name + " to the others", std::move(grid));
  }

  // Lids come before the channels, which are many.
  Sheet OneFace(std::uint16_t face) const {
    const std::string& name = cast_.faces[face].name;
    Sheet sheet = Titled("face-" + name + ".png", name);
    for (const auto& [heading, kind] : {std::pair{"Expressions", ExpressionKind::kExpression},
                                        {"Mouth shapes", ExpressionKind::kMouth},
                                        {"Channels", ExpressionKind::kChannel}}) {
      Section section{.heading = heading, .in_a_row = kInARow};
      for (const std::uint16_t e : OfKind(cast_, kind)) section.cells.push_back(Worn(face, e));
      if (kind == ExpressionKind::kChannel) sheet.sections.push_back(LidsOf(face));
      if (!section.cells.empty()) sheet.sections.push_back(std::move(section));
    }
    Complain(sheet);
    return sheet;
  }

 private:
  static Sheet Titled(std::string file, std::string title) {
    Sheet sheet;
    sheet.file = std::move(file);
    sheet.title = std::move(title);
    return sheet;
  }

  Sheet Titled(std::string file, std::string title, Section section) const {
    Sheet sheet = Titled(std::move(file), std::move(title));
    sheet.about = fmt::format("{}: {}", show_.name, CountsOf(cast_));
    sheet.sections = {std::move(section)};
    return sheet;
  }

  // A face at rest. Flaws are found in poses and told on their cells, so that there are none here.
  Cell Plain(std::uint16_t face, std::string label) const {
    return {cast_.faces[face].name, std::move(label), "", Portrait(face)};
  }

  // With what the inspection found of this face in poses of this expression.
  Cell Worn(std::uint16_t face, std::uint16_t expression) const {
    const std::string& name = cast_.expressions[expression].name;
    return {cast_.faces[face].name, name, flaws_.On(cast_.faces[face].name, name),
            Wearing(cast_, face, expression)};
  }

  // Flaws of shut lids are known by the label "lids shut" alone.
  Section LidsOf(std::uint16_t face) const {
    Section section{.heading = "Lids shut", .in_a_row = kInARow};
    for (const Lids& lids : kLids) {
      Cell cell = Worn(face, 0);
      cell.label = lids.name;
      cell.flaws = flaws_.On(cell.face, cell.label);
      cell.scene.weights.lids_shut = lids.shut;
      section.cells.push_back(std::move(cell));
    }
    return section;
  }

  // The line below a face's title: how many of its pictures have flaws; "no flaws" only where
  // all was inspected.
  void Complain(Sheet& sheet) const {
    std::size_t flawed = 0;
    for (const Section& section : sheet.sections)
      flawed += static_cast<std::size_t>(
          std::ranges::count_if(section.cells, [](const Cell& cell) { return !cell.flaws.empty(); }));
    sheet.is_flawed = flawed > 0;
    std::string found = flaws_.any() ? "no flaws" : flaws_.summary();
    if (flawed > 0) found = fmt::format("{} pictures with flaws", flawed);
    sheet.about = fmt::format("{}: {}; {}", show_.name, CountsOf(cast_), found);
  }

  const show::Show& show_;
  const face::Cast& cast_;
  const Flaws& flaws_;
};

}  // namespace

std::string Counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string CountsOf(const face::Cast& cast) {
  return fmt::format("{}, {}, {}, {}", Counted(cast.faces.size(), "face"),
                     Counted(OfKind(cast, ExpressionKind::kExpression).size(), "expression"),
                     Counted(OfKind(cast, ExpressionKind::kMouth).size(), "mouth shape"),
                     Counted(OfKind(cast, ExpressionKind::kChannel).size(), "channel"));
}

// Sheets for the whole cast first; a face's own sheet is looked up by name.
std::vector<Sheet> PlanSheets(const show::Show& show, const Flaws& flaws) {
  const Planner planner(show, flaws);
  std::vector<Sheet> sheets{planner.WholeCast(), planner.Sides(), planner.Styles()};
  if (show.cast.faces.size() > 1) sheets.push_back(planner.Morphs());
  for (std::uint16_t face = 0; face < show.cast.faces.size(); ++face) sheets.push_back(planner.OneFace(face));
  return sheets;
}

}  // namespace kaori::authoring
