// Hair, clothes and teeth of a show's faces, fitted to heads of another shape.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// What lends a look to heads: a show's cast (borrowed), and which of its faces each head is like.
struct Lender {
  const face::Cast* show = nullptr;  // Null: nobody lends.
  // One for each head; an index of show->faces. Unused without a show.
  std::vector<std::size_t> like;
  // One for each skin vertex, on the show's faces; empty: the heads could not be laid over each other.
  std::vector<Spot> spots;
};

// For each of `heads` heads the face of the show's cast whose look it takes: by the names, one by one, the
// last one for all that follow; the first face where no name is given. Names of no face, and names where
// there is no show (null), go to `findings`.
std::vector<std::size_t> FacesToBeLike(const std::vector<std::string>& names, std::size_t heads,
                                       const face::Cast* show, Findings& findings);

// Leads hair and clothes of the face that each head is like through a warp from that face to the head, by the
// outline of both (OutlinePulls); teeth and tongue too, where the heads have none of their own. Each head
// gets props of its own, "HEAD PROP" by name. Fills props, and each face's list of them and iris. Heads that
// cannot be laid over stay as they are. Positions go through the warp, tangents through its derivative and
// normals through the inverse transpose of it. Returns what to tell people.
std::string DressLike(const Heads& heads, const Lender& lender, face::Cast& cast);

}  // namespace kaori::import
