/// A page to look at a path, to play it back, and to edit a drawing: one HTML file that needs no server and no network.
///
///   write_file("plan.html", viewer_page({.problem = problem, .path = &path, .traces = traces, .score = score}));
///
/// What it shows: the drawing (if the map has one) and the path in three views, what is driven when, the planner's
/// traces as layers, the figures. Of a drawing it edits connections, their curves, fills, cuts and the start, and saves
/// them as a file of edits (docs/viewer.md). The same data give the same bytes.
///
/// The page is plain JavaScript on a Canvas, without a library: nothing needs to be fetched or updated to build oxturn,
/// and pointer events, Path2D and isPointInPath are all that it uses. Its sources are the files in page/, which CMake
/// embeds. Its policy forbids every request. A path of 200,000 segments makes a page of some 5 MB.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "geometry/trace.hpp"
#include "maps/problem.hpp"
#include "metrics/score.hpp"

namespace oxturn {

/// What the page shows. It is only used during the call.
struct ViewerData {
  const Problem& problem;                 // map, drawing, robot and start
  const Path* path = nullptr;             // nullptr: none was found
  std::vector<Trace> traces = {};         // of the planner's stages, in their order
  std::optional<Score> score = {};        // figures of the path
  std::string drawing_file = {};          // name of the drawing's file, for title and commands; empty: the map's name
  std::string edits = {};                 // the edits that the drawing was planned with, as JSON; empty: none
  std::vector<std::string> remarks = {};  // sentences on the path, such as areas that are not filled
};

/// The page. Throws std::invalid_argument if `edits` is no JSON object. Linear in the number of vertices.
std::string viewer_page(const ViewerData& data);

}  // namespace oxturn
