// Hair, clothes and teeth of a show's faces, fitted to heads of another shape.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// What lends a look to heads: a show's cast, and which of its faces each head is like.
struct Lender {
  const face::Cast* show = nullptr;  // Null: nobody lends.
  std::vector<std::size_t> like;     // One for each head; a face of the show.
  std::vector<Spot> spots;           // One for each skin vertex, on the show's faces; empty: not known.
};

// For each of `heads` heads the face of the show's cast whose look it takes: by the names, one by one, the
// last one for all that follow; the first face where no name is given. Names of no face go to `findings`.
std::vector<std::size_t> FacesToBeLike(const std::vector<std::string>& names, std::size_t heads,
                                       const face::Cast* show, Findings& findings);

// Leads hair and clothes of the face that each head is like through a warp from that face to the head, by the
// landmarks of both; teeth and tongue too, where the heads have none of their own. Fills props, and each
// face's list of them and iris. Heads that cannot be laid over stay as they are. Returns what to tell people.
std::string DressLike(const Heads& heads, const Lender& lender, face::Cast& cast);

}  // namespace kaori::import
