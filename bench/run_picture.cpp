#include "bench/run_picture.hpp"

namespace oxturn {

std::string run_picture(const Problem& problem, const Path* path, const std::optional<Score>& score,
                        const std::vector<Trace>& traces, PictureOptions options) {
  std::vector<Ring> missed;
  if (score)
    for (const MissedPiece& piece : score->missed)
      missed.insert(missed.end(), piece.outline.begin(), piece.outline.end());
  options.missed = &missed;
  options.traces = &traces;
  return to_svg(problem, path, options);
}

}  // namespace oxturn
