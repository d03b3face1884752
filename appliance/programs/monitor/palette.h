// The colours of the operators' monitor: bright on dark, told apart from two metres, also by those who see
// no red or no green, since each stands beside its word.
#pragma once

#include <array>

#include "render/image/fill.h"

namespace kaori::monitor {

using image::Colour;

inline constexpr Colour kNight{9, 10, 13}, kPanel{20, 23, 29}, kGroove{39, 44, 54}, kQuiet{142, 151, 167},
    kSoft{192, 199, 211}, kText{237, 240, 245};
inline constexpr Colour kRed{255, 92, 82}, kAmber{255, 184, 102}, kGreen{98, 212, 138}, kBlue{111, 170, 255};
// Those of the demo's page, for the same things.
inline constexpr Colour kFace{255, 184, 102}, kExpression{255, 143, 163}, kStyle{111, 211, 232},
    kScene{183, 156, 255}, kMotion{143, 208, 168};
// Of levels, by who has them.
inline constexpr Colour kByCue{143, 208, 168}, kByRemote{183, 156, 255}, kByLips{255, 143, 163},
    kByVoice{244, 120, 214};
inline constexpr std::array<Colour, 8> kByRole{{{255, 184, 102},
                                                {96, 190, 255},
                                                {180, 230, 90},
                                                {255, 120, 150},
                                                {90, 226, 208},
                                                {240, 226, 96},
                                                {196, 150, 255},
                                                {255, 150, 84}}};

}  // namespace kaori::monitor
