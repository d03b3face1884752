// Roles of heads as a report says them, and as a show plays them.
#pragma once

#include <string>
#include <string_view>

#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// "ARKit: 0.7 x jawOpen + 1 x mouthFunnel".
std::string MadeOf(const Heads& heads, const Role& role);

// "ARKit jawOpen"; empty: none.
std::string MeaningIn(const Shape& shape);

// Null where the heads have no such role.
const Role* FindRole(const Heads& heads, std::string_view name);

// Moods are called, vowels are mouths, all else is a channel.
face::ExpressionKind KindOfRole(std::string_view role);

}  // namespace kaori::import
