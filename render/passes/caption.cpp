#include "render/passes/caption.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/vec4.hpp>

#include "render/gl/draw_state.h"
#include "render/image/break_line.h"
#include "render/passes/shader_library.h"

namespace kaori::passes {
namespace {

// Parts of the picture's height. Letters are read at 960 x 540 and from across a table at 1920 x 1080.
constexpr float kLetters = 0.0285F;
constexpr float kMargin = 0.030F;
// Of all lines.
constexpr float kMostHeight = 0.7F;
constexpr int kSmallest_px = 10;

// The plate stands beside the face: so much of the picture's width, or space for this many letters.
constexpr float kWidest = 0.37F;
constexpr int kFewestLetters = 18;

// Parts of the letters' size.
constexpr float kStep = 1.38F;
constexpr float kBorder = 0.75F;

int Rounded(float px) {
  return static_cast<int>(std::lround(px));
}

}  // namespace

// Everything follows the picture's height, so that a caption looks the same on any screen.
CaptionPass::Measures CaptionPass::MeasuresFor(const gl::Canvas& canvas) {
  const auto height_px = static_cast<float>(canvas.height_px());
  const auto width_px = static_cast<float>(canvas.width_px());
  const int letters = std::max(Rounded(kLetters * height_px), kSmallest_px);
  const int border = Rounded(kBorder * static_cast<float>(letters));
  const int margin = Rounded(kMargin * height_px);
  const int beside_px = std::max(Rounded(kWidest * width_px), kFewestLetters * letters);
  return {.letters = letters,
          .step = Rounded(kStep * static_cast<float>(letters)),
          .border = border,
          .margin = margin,
          .line_px = std::max(std::min(beside_px, canvas.width_px()) - 2 * (margin + border), 1)};
}

CaptionPass::CaptionPass(gl::Program program, image::Lettering lettering)
    : program_(std::move(program)),
      lettering_(std::move(lettering)),
      plate_(program_.Find("plate")),
      border_(program_.Find("border")),
      opacity_(program_.Find("opacity")),
      everywhere_({}, 3) {
  program_.BindSampler("letters", 0);
}

Result<CaptionPass> CaptionPass::Open() {
  auto program =
      gl::Program::Make({.library = ShaderLibrary(), .vertex = "caption.vert", .fragment = "caption.frag"});
  if (!program) return tl::unexpected(program.error());
  auto lettering = image::Lettering::Open();
  if (!lettering) return tl::unexpected(lettering.error());
  return CaptionPass(std::move(*program), std::move(*lettering));
}

// The lines as they are drawn: broken, at most as many as fit, and a word that is too long alone cut with an
// ellipsis.
std::vector<std::string> CaptionPass::Fitting(const Measures& m, int most_px) {
  std::vector<std::string> lines;
  const auto fits = [&](std::string_view text) { return lettering_.width_px(text, m.letters) <= m.line_px; };
  for (const std::string& line : lines_) image::BreakLine(line, fits, lines);
  const auto most = static_cast<std::size_t>(std::max(most_px / m.step, 1));
  if (lines.size() > most) lines.resize(most);
  for (std::string& line : lines) line = image::Shorten(lettering_, line, m.letters, m.line_px);
  return lines;
}

// The texture is as large as the longest line and all lines ask for: its alpha is the letters' mask.
void CaptionPass::WriteLetters(const std::vector<std::string>& lines, const gl::Canvas& canvas) {
  lines_ = lines;
  canvas_width_px_ = canvas.width_px();
  canvas_height_px_ = canvas.height_px();
  const Measures m = MeasuresFor(canvas);
  const std::vector<std::string> fitting =
      Fitting(m, Rounded(kMostHeight * static_cast<float>(canvas.height_px())));
  int width_px = 1;
  for (const std::string& line : fitting) width_px = std::max(width_px, lettering_.width_px(line, m.letters));
  auto picture = image::Picture::Blank(width_px, std::max(static_cast<int>(fitting.size()), 1) * m.step);
  int y_px = picture.height_px;
  for (const std::string& line : fitting)
    lettering_.Draw(line, {.size_px = m.letters}, 0, y_px -= m.step, picture);
  // A new texture, since texts differ in size; not in a frame of the show.
  letters_ = gl::Texture({.width_px = picture.width_px, .height_px = picture.height_px},
                         std::as_bytes(std::span(picture.rgbx)));
  border_px_ = m.border;
  plate_box_ = fitting.empty() ? gl::Box{}
                               : gl::Box{m.margin, m.margin, picture.width_px + 2 * m.border,
                                         picture.height_px + 2 * m.border};
}

// The scissor box is the plate, so the one triangle covers no more.
void CaptionPass::Draw(const scene::Caption& caption, const gl::Canvas& canvas) {
  if (!(caption.shown > 0) || caption.lines.empty()) return;
  const bool same_size = canvas_width_px_ == canvas.width_px() && canvas_height_px_ == canvas.height_px();
  if (!same_size || lines_ != caption.lines) WriteLetters(caption.lines, canvas);
  gl::Apply({.cull = gl::Cull::kNone, .depth = gl::Depth::kOff, .blend = gl::Blend::kOver});
  letters_.Bind(0);
  program_.Use();
  const gl::Box& b = plate_box_;
  gl::Program::Set(plate_, glm::vec4(b.left_px, b.bottom_px, b.width_px, b.height_px));
  gl::Program::Set(border_, border_px_);
  gl::Program::Set(opacity_, std::min(caption.shown, 1.0F));
  canvas.BeginPicture();
  canvas.Within(b);
  everywhere_.Draw();
  canvas.SetStamp({});
}

}  // namespace kaori::passes
