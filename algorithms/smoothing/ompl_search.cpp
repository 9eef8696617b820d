#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "algorithms/smoothing/car_space.hpp"
#include "algorithms/smoothing/detour_search.hpp"

namespace oxturn {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kRange = 8;            // radii: the longest motion; long enough for a loop
constexpr double kShortenStep = 1;      // radii, between poses of a path to be shortened
constexpr std::size_t kMostPoses = 40;  // of these; more are further apart
constexpr std::size_t kMostIdle = 10;   // checks of the end of the search without a new curve
// Curves that take the time of one pose of lattice_search, forward and with Reeds-Shepp curves.
constexpr std::size_t kCurvesToPose = 10, kReverseCurvesToPose = 3;

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<ob::SE2StateSpace::StateType>();
  return {{s->getX(), s->getY()}, s->getYaw()};
}

void assign(ob::State* state, const Pose& pose) {
  auto* s = state->as<ob::SE2StateSpace::StateType>();
  s->setXY(pose.at.x(), pose.at.y());
  s->setYaw(std::remainder(pose.heading, 2 * kPi));
}

/// The pose `metres` along the curve.
Pose pose_along(const Curve& curve, double metres) {
  Pose at = curve.from;
  for (CurvePiece piece : curve.pieces) {
    const bool ends = metres <= piece.length;
    if (ends) piece.length = metres;
    metres -= piece.length;
    at = after(at, piece, curve.radius);
    if (ends) break;
  }
  return at;
}

/// Poses and the shortest curves between them. (OMPL's own spaces of that kind abort the program for some aligned
/// poses: an assertion fails in Debian 12.)
class CarStateSpace : public ob::SE2StateSpace {
 public:
  explicit CarStateSpace(const CarSpace& space) : space_(space) {}
  double distance(const ob::State* a, const ob::State* b) const override {
    ++curves_;
    return space_.least_length(pose_of(a), pose_of(b));
  }
  /// How many there were: nearly all the time goes into them.
  std::size_t curves() const { return curves_; }
  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override {
    const Curve curve = space_.shortest(pose_of(from), pose_of(to));
    assign(state, t < 1 ? pose_along(curve, t * curve.length()) : pose_of(to));
  }
  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return space_.reverse(); }
  bool hasSymmetricInterpolate() const override { return space_.reverse(); }
  double getMaximumExtent() const override { return space_.bounds().size().norm() + 8 * kPi * space_.radius(); }

 private:
  const CarSpace& space_;
  mutable std::size_t curves_ = 0;
};

/// Draws poses by our generator: OMPL's have one seed for the process.
class PoseSampler : public ob::StateSampler {
 public:
  PoseSampler(const ob::StateSpace* states, const Box& box, std::uint64_t seed)
      : ob::StateSampler(states), box_(box), random_(seed) {}
  void sampleUniform(ob::State* state) override { draw(state, box_); }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    Box box;
    box.add(pose_of(near).at);
    box.grow(distance);
    draw(state, box);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    Pose pose = pose_of(mean);
    pose.at += deviation * Point(random_.normal(), random_.normal());
    pose.heading += deviation * random_.normal();
    assign(state, pose);
  }

 private:
  void draw(ob::State* state, const Box& box) {
    const double x = random_.between(box.low.x(), box.high.x()), y = random_.between(box.low.y(), box.high.y());
    assign(state, {{x, y}, random_.between(-kPi, kPi)});
  }
  Box box_;
  Rng random_;
};

class Validity : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, const CarSpace& space) : ob::StateValidityChecker(si), space_(space) {}
  bool isValid(const ob::State* state) const override {
    const Point at = pose_of(state).at;
    return space_.free(Polyline{at, at});
  }

 private:
  const CarSpace& space_;
};

class Motions : public ob::MotionValidator {
 public:
  Motions(const ob::SpaceInformationPtr& si, const CarSpace& space) : ob::MotionValidator(si), space_(space) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return space_.free(space_.shortest(pose_of(a), pose_of(b)));
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    last.second = 0;
    if (last.first != nullptr) si_->copyState(last.first, a);
    return checkMotion(a, b);
  }

 private:
  const CarSpace& space_;
};

/// A planner of OMPL whose own generator, too, has our seed.
template <class Base>
class Seeded : public Base {
 public:
  Seeded(const ob::SpaceInformationPtr& si, std::uint64_t seed) : Base(si) {
    this->rng_.setLocalSeed(static_cast<std::uint_fast32_t>(seed));
  }
};

/// Two trees where curves can be driven back; forwards only a tree from the goal would grow by loops.
std::shared_ptr<ob::Planner> make_planner(const ob::SpaceInformationPtr& si, const CarSpace& space,
                                          std::uint64_t seed) {
  if (!space.reverse()) {
    auto tree = std::make_shared<Seeded<og::RRT>>(si, seed);
    tree->setRange(kRange * space.radius());
    return tree;
  }
  auto trees = std::make_shared<Seeded<og::RRTConnect>>(si, seed);
  trees->setRange(kRange * space.radius());
  return trees;
}

std::vector<Pose> solve(const CarSpace& space, const std::vector<Pose>& from, const Pose& to, DetourEffort& effort,
                        const Context& context) {
  if (!space.free(Polyline{to.at, to.at})) return {};  // OMPL would sleep until the search is ended from outside
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const std::uint64_t seed = mix(context.seed(), "detour");
  auto states = std::make_shared<CarStateSpace>(space);
  ob::RealVectorBounds bounds(2);
  const Box& box = space.bounds();
  for (unsigned axis = 0; axis < 2; ++axis) {  // lanes may end on the boundary, but for rounding
    bounds.setLow(axis, box.low[axis] - space.radius());
    bounds.setHigh(axis, box.high[axis] + space.radius());
  }
  states->setBounds(bounds);
  states->setStateSamplerAllocator(
      [&](const ob::StateSpace* s) { return std::make_shared<PoseSampler>(s, box, seed); });
  auto si = std::make_shared<ob::SpaceInformation>(states);
  si->setStateValidityChecker(std::make_shared<Validity>(si, space));
  si->setMotionValidator(std::make_shared<Motions>(si, space));
  si->setup();
  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> state(states);
  for (const Pose& pose : from) {
    assign(state.get(), pose);
    definition->addStartState(state);
  }
  assign(state.get(), to);
  definition->setGoalState(state);
  const auto planner = make_planner(si, space, seed);
  planner->setProblemDefinition(definition);
  planner->setup();
  const std::size_t each = space.reverse() ? kReverseCurvesToPose : kCurvesToPose, most = effort.most() * each;
  // Where OMPL takes the goal for invalid it sleeps until the condition holds, and computes nothing.
  std::size_t before = 0, idle = 0;
  const ob::PlannerTerminationCondition done([&] {
    idle = states->curves() == before ? idle + 1 : 0;
    before = states->curves();
    return before >= most || idle > kMostIdle || context.cancelled();
  });
  const bool solved = planner->solve(done) == ob::PlannerStatus::EXACT_SOLUTION;
  effort.spend(states->curves() / each);
  if (!solved) return {};
  const auto& path = *definition->getSolutionPath()->as<og::PathGeometric>();
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < path.getStateCount(); ++i)
    poses.push_back(pose_of(path.getState(static_cast<unsigned>(i))));
  return poses;
}

Curve joined(const std::vector<Pose>& poses, const CarSpace& space) {
  Curve all{poses.front(), poses.back(), space.radius(), {}};
  for (std::size_t i = 1; i < poses.size(); ++i)
    for (const CurvePiece& piece : space.shortest(poses[i - 1], poses[i]).pieces) all.pieces.push_back(piece);
  return all;
}

/// The poses along the path, between which it may be shortened; the ends of its curves among them.
std::vector<Pose> poses_along(const std::vector<Pose>& path, const CarSpace& space) {
  const double step = std::max(kShortenStep * space.radius(), joined(path, space).length() / kMostPoses);
  std::vector<Pose> poses{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Curve curve = space.shortest(path[i - 1], path[i]);
    for (double s = step; s < curve.length(); s += step) poses.push_back(pose_along(curve, s));
    poses.push_back(path[i]);
  }
  return poses;
}

/// The cheapest sequence of free curves through some of the poses, from the first to the last.
std::vector<Pose> shortened(const std::vector<Pose>& poses, const CarSpace& space) {
  std::vector<double> cost(poses.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(poses.size(), 0);
  cost[0] = 0;
  for (std::size_t to = 1; to < poses.size(); ++to)
    for (std::size_t from = 0; from < to; ++from) {
      const Curve curve = space.shortest(poses[from], poses[to]);
      const double through = cost[from] + space.cost(curve);
      if (!(through < cost[to]) || !space.free(curve)) continue;
      cost[to] = through, before[to] = from;
    }
  std::vector<Pose> result;
  for (std::size_t i = poses.size() - 1; i > 0; i = before[i]) result.push_back(poses[i]);
  result.push_back(poses.front());
  std::ranges::reverse(result);
  return result;
}

}  // namespace

std::optional<Curve> ompl_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                 DetourEffort& effort, const Context& context) {
  const std::vector<Pose> path = solve(space, from, to, effort, context);
  if (path.empty()) return std::nullopt;
  Curve detour = joined(shortened(poses_along(path, space), space), space);
  detour.to = to;
  return space.free(detour) ? std::optional(std::move(detour)) : std::nullopt;
}

}  // namespace oxturn
