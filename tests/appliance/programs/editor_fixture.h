// The editor in a show without a picture: input on a board, the performance, and the face as it is composed.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "appliance/core/board/press_log.h"
#include "appliance/core/performance/animate.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/editor/keys.h"
#include "render/face/composer.h"
#include "tests/appliance/core/board_file.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using editor::ExpressionEditor;
using editor::Work;
namespace key = editor::key;

inline constexpr Duration kEditorFrame = 16'666'667ns;
inline constexpr std::uint8_t kF1 = 0x3A, kKey2 = 0x1F, kB = 0x05, kQ = 0x14, kW = 0x1A, kX = 0x1B;

inline show::Show PlayedShow() {
  show::Show show;
  show.cast = MakeSyntheticCast({.columns = 24, .rows = 18});
  for (std::uint16_t i = 0; i < 4; ++i) show.buttons[i] = {show::CallKind::kFace, i};
  for (std::uint16_t i = 0; i < 3; ++i) show.buttons[4U + i] = {show::CallKind::kExpression, i};
  show.buttons[7] = {show::CallKind::kScene, 1};
  show.keys = {{kQ, {show::CallKind::kStyle, 0}}, {kW, {show::CallKind::kExpression, 2}}};
  show.scenes.resize(2);
  show.scenes[1].key_usage = kF1;
  show.scenes[1].face = 2;
  show.motions = {{"nod", key::k1, {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.3F}, {1, 0}}}}},
                  {"bee", kB, {{show::MotionTarget::kHeadPitch, 0, {{0, 0}, {0.5F, 0.3F}, {1, 0}}}}}};
  return show;
}

// A stage without a picture: the same steps in the same order.
class EditorPlay : public ::testing::Test {
 protected:
  EditorPlay() {
    board_.surface.source = board_.keys.source = board_.pointer.source = board::SourceState::kLive;
    for (auto& stick : board_.sticks) stick.source = board::SourceState::kLive;
    Enter();
  }

  void Enter() {
    editor_.reset();
    show_ = PlayedShow();
    editor_ = ExpressionEditor::Open(folder_.folder(), show_);
    composer_ = std::make_unique<face::Composer>(show_.cast);
    state_ = performance::Opening(show_, board_, now_);
    At(state_.knobs, performance::Knob::kLife) = At(state_.shown, performance::Knob::kLife) = 0;
    Frame();
    Frame();
  }

  void Frame() {
    now_ += kEditorFrame;
    performance::InputEvents events = performance::ReadEvents(state_.seen, board_);
    const board::Snapshot& rest = editor_->Play(board_, events, show_, state_, now_);
    for (const auto& [index, work] : editor_->renewed()) {
      show_.cast.expressions[index].displacement = work->pulls_m;
      show_.cast.expressions[index].lids = work->lids;
      composer_->Renew(index);
    }
    auto performed = performance::Animate(state_, rest, events, show_, now_);
    state_ = performed.state;
    editor_->Describe(performed.scene);
    scene_ = std::move(performed.scene);
    editor_->Look(show_.cast, composer_->Compose(scene_.weights, face::Detail::kCage), scene_, 16.0F / 9);
  }
  void Run(Duration time) {
    for (const Time end = now_ + time; now_ < end;) Frame();
  }

  void Hold(std::uint8_t usage, bool down) {
    auto& word = board_.keys.value.down[usage / 32U];
    word = down ? word | (1U << (usage % 32U)) : word & ~(1U << (usage % 32U));
    if (down) board::NotePress(board_.keys.value, usage, now_);
  }
  void Strike(std::uint8_t usage) {
    Hold(usage, true);
    Frame();
    Hold(usage, false);
    Frame();
  }
  void StrikeWithShift(std::uint8_t usage) {
    Hold(key::kLeftShift, true);
    Strike(usage);
    Hold(key::kLeftShift, false);
  }
  void Type(std::string_view text) {
    for (const char c : text) Strike(static_cast<std::uint8_t>(key::kA + (c - 'a')));
  }
  void Push(std::size_t button) {
    board::NotePress(board_.surface.value, button, now_);
    Frame();
  }
  void Turn(std::size_t dial, float turns) {
    board_.surface.value.counts[dial] += static_cast<std::int32_t>(std::lround(turns * 256));
    Frame();
  }
  void Press(glm::vec2 place) {
    board_.pointer.value.x = place.x;
    board_.pointer.value.y = place.y;
    board_.pointer.value.buttons_down = 1;
    ++board_.pointer.value.pushes[0];
    Frame();
  }
  void Drag(glm::vec2 step) {
    board_.pointer.value.x += step.x;
    board_.pointer.value.y += step.y;
    Frame();
  }
  void Release() {
    board_.pointer.value.buttons_down = 0;
    Frame();
  }

  // Where the handle stands in the picture, 0..1 from the left top, by the composed face.
  glm::vec2 PositionOf(const char* point) {
    editor::HandlePicker picker(show_.cast);
    picker.Look(show_.cast, composer_->Compose(scene_.weights, face::Detail::kCage), scene_, 16.0F / 9);
    return picker.position(PointNamed(show_.cast, point));
  }
  void ChooseHandle(const char* point) {
    Press(PositionOf(point));
    Release();
    ASSERT_EQ(Chosen(), point);
  }
  std::string Chosen() const {
    return editor_->chosen() < 0 ? ""
                                 : show_.cast.net.points[static_cast<std::size_t>(editor_->chosen())].name;
  }
  const Work& work() const { return editor_->session().work(); }
  glm::vec3 PullOf(const char* point) const { return work().pulls_m[PointNamed(show_.cast, point)]; }
  bool PlaysAMotion() const {
    return std::ranges::any_of(state_.voices, [](const auto& voice) { return voice.motion >= 0; });
  }
  std::string Caption() const {
    std::string all;
    for (const std::string& line : scene_.caption.lines) all += line + '\n';
    return all;
  }
  void SaveAs(const char* name) {
    Strike(key::kEnter);
    Type(name);
    Strike(key::kEnter);
    editor_->Finish();
    Frame();
  }

  board::BoardFile folder_;
  board::Snapshot board_;
  Time now_ = Time{} + 100s;
  show::Show show_;
  std::unique_ptr<ExpressionEditor> editor_;
  std::unique_ptr<face::Composer> composer_;
  performance::State state_;
  scene::Scene scene_;
};

}  // namespace kaori::tests
