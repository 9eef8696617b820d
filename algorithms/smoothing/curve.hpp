/// Curves that a car-like robot can drive: arcs of its least turning radius and straight lines.
///
///   const Curve curve = dubins_curve({{0, 0}, 0}, {{0, 6}, kPi}, 4);          // forward only
///   const Curve shorter = reeds_shepp_curve({{0, 0}, 0}, {{0, 6}, kPi}, 4);   // with cusps
///   for (Leg& leg : sampled(curve, 0.003, false)) ...                         // one leg for each gear
///
/// Source      Dubins 1957, by the closed forms of Shkel and Lumelsky 2001; Reeds and Shepp 1990, by their closed forms
/// Guarantee   finite; ends within 1e-6 radii of the given pose; sampled() ends there exactly
/// Complexity  a curve costs a few microseconds
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/math.hpp"
#include "geometry/path.hpp"

namespace oxturn {

/// Of a car-like robot. In reverse the heading is opposite to the motion.
struct Pose {
  Point at{0, 0};
  double heading = 0;  // radians
};
/// Of the straight drive to another point, radians.
inline double heading(const Point& from, const Point& to) { return math::atan2(to.y() - from.y(), to.x() - from.x()); }
inline Point direction(const Pose& pose) { return {math::cos(pose.heading), math::sin(pose.heading)}; }
/// The pose `metres` ahead along the heading.
inline Pose ahead(const Pose& pose, double metres) { return {pose.at + metres * direction(pose), pose.heading}; }
/// The same position with the opposite heading.
inline Pose turned_round(const Pose& pose) { return {pose.at, pose.heading + kPi}; }

enum class Steering { left, straight, right };
struct CurvePiece {
  Steering steering = Steering::straight;
  double length = 0;  // metres, >= 0
  Gear gear = Gear::forward;
};

struct Curve {
  Pose from, to;
  double radius = 1;  // of the arcs
  std::vector<CurvePiece> pieces = {};
  double length() const;
  /// Changes of gear.
  std::size_t cusps() const;
};

/// Where the piece leads from `from`.
Pose after(const Pose& from, const CurvePiece& piece, double radius);

/// The pieces of a curve without its poses, for searches that look at many.
struct Word {
  std::array<CurvePiece, 5> pieces{};
  std::size_t count = 0;
  double length = 0;  // metres
  std::span<const CurvePiece> driven() const& { return {pieces.data(), count}; }
  void driven() const&& = delete;  // would outlive the word
};
inline Curve curve_of(const Word& word, const Pose& from, const Pose& to, double radius) {
  return {from, to, radius, {word.driven().begin(), word.driven().end()}};
}

/// The shortest curve driven forwards. `radius` > 0.
Curve dubins_curve(const Pose& from, const Pose& to, double radius);
/// Its length alone.
double dubins_distance(const Pose& from, const Pose& to, double radius);
struct DubinsWords {
  std::array<Word, 6> words;
  std::size_t count = 0;
  std::span<const Word> all() const& { return {words.data(), count}; }
  void all() const&& = delete;  // would outlive the words
};
/// The shortest curve of each of the words LSL, RSR, LSR, RSL, RLR and LRL that exists, shortest first: alternatives
/// where an obstacle is in the way.
DubinsWords dubins_words(const Pose& from, const Pose& to, double radius);
/// The shortest curve driven forwards or backwards, with cusps in between.
Word reeds_shepp_word(const Pose& from, const Pose& to, double radius);
Curve reeds_shepp_curve(const Pose& from, const Pose& to, double radius);
/// Its length alone.
double reeds_shepp_distance(const Pose& from, const Pose& to, double radius);
/// The curve of the opposite motion: from its end to its beginning, headings turned round, so that the gears stay.
Curve opposite(const Curve& curve);

/// Tool widths: error of curves sampled for paths, of the thousandth that these may have (geometry/bends.hpp), so that
/// leaving out a sample near another one makes no bend too sharp.
inline constexpr double kChordError = 0.8e-3;

/// As chords that leave the curve by `chord_error` metres at most; one leg for each gear. Ends exactly in `curve.to`.
/// Empty if the curve has no length.
std::vector<Leg> sampled(const Curve& curve, double chord_error, bool tool);

}  // namespace oxturn
