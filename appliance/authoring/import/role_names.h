// Roles of heads as a report says them, and as a show plays them.
#pragma once

#include <string>
#include <string_view>

#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// What the role is made of, as the report says it: "ARKit: 0.7 x jawOpen + 1 x mouthFunnel", by the
// file's own names.
std::string MadeOf(const Heads& heads, const Role& role);

// "ARKit jawOpen": style and the style's own spelling; empty: none.
std::string MeaningIn(const Shape& shape);

// Null where the heads have no such role; borrowed from `heads`.
const Role* FindRole(const Heads& heads, std::string_view name);

// Moods (smile, angry, sad, surprised) are called by an operator, vowels and "mouth_..." are mouths that the
// lips play, all else is a channel.
face::ExpressionKind KindOfRole(std::string_view role);

}  // namespace kaori::import
