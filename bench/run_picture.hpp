/// The picture of a run: the path with the pieces that it missed. For every command.
///
///   write_file("plan.svg", run_picture(problem, &path, score, traces));
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "maps/picture.hpp"
#include "metrics/score.hpp"

namespace oxturn {

/// `path`: nullptr if there is none; `score`: of this path. `options`: all but missed pieces and traces.
std::string run_picture(const Problem& problem, const Path* path, const std::optional<Score>& score,
                        const std::vector<Trace>& traces, PictureOptions options = {});

}  // namespace oxturn
