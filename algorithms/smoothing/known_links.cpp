#include "algorithms/smoothing/known_links.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/multiplicative_hash.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSlotsOfAStroke = 16, kLeastSlots = 256, kMostSlots = 1u << 17;  // of some 200 bytes
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool same(const Pose& a, const Pose& b) { return a.at == b.at && a.heading == b.heading; }

}  // namespace

KnownLinks::KnownLinks(const CarSpace& space, std::size_t strokes)
    : space_(space),
      slots_(std::bit_ceil(std::clamp(kSlotsOfAStroke * strokes, kLeastSlots, kMostSlots)),
             Slot{{}, {}, kNothing, std::nullopt}) {}

KnownLinks::Slot& KnownLinks::slot(const Pose& from, const Pose& to) {
  std::uint64_t key = 0;
  for (const double x : {from.at.x(), from.at.y(), from.heading, to.at.x(), to.at.y(), to.heading})
    key = (std::rotl(key, 23) ^ std::bit_cast<std::uint64_t>(x)) * kHashFactor;
  return slots_[(key >> 32) & (slots_.size() - 1)];
}

std::optional<Curve> KnownLinks::find(const Pose& from, const Pose& to, double most) {
  Slot& known = slot(from, to);
  const bool is_this = same(known.from, from) && same(known.to, to);
  // The link found is the cheapest one, however much it might have cost.
  if (is_this && known.link) return space_.cost(*known.link) < most ? known.link : std::nullopt;
  if (is_this && most <= known.most) return std::nullopt;
  known = {from, to, most, space_.simple_link(from, to, most)};
  return known.link;
}

}  // namespace oxturn
