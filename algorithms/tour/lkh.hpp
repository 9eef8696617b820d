/// LKH (Helsgaun 2000), if it is installed: the reference that other tours are compared with.
///
///   if (const auto program = find_lkh()) tour = lkh_tour(problem, *program, context);
///
/// LKH is free for research only, so oxturn does not contain it. It gets the problem as an asymmetric matrix
/// (node_matrix.hpp) in a folder of its own, which is removed afterwards.
#pragma once

#include <optional>
#include <string>

#include "algorithms/context.hpp"
#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

/// The file `LKH` or `lkh` in a folder of the environment variable PATH.
std::optional<std::string> find_lkh();

/// One run of LKH with the seed 1, ended at the context's deadline or by cancel(). Costs are rounded to whole numbers,
/// with as many digits as LKH can take (30 bits for the dearest connection and the constant of node_matrix.hpp).
/// Throws std::invalid_argument for problems with precedence, std::runtime_error if LKH cannot be run or leaves no
/// tour.
Tour lkh_tour(const TourProblem& problem, const std::string& program, const Context& context);

}  // namespace oxturn
