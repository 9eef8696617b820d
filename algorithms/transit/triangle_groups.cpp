#include "algorithms/transit/triangle_groups.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace oxturn {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

Point centre_of(const Mesh& mesh, const Mesh::Triangle& triangle) {
  Point sum(0, 0);
  for (const std::int32_t v : triangle.vertex) sum += mesh.points()[static_cast<std::size_t>(v)];
  return sum / 3;
}

}  // namespace

TriangleGroups::TriangleGroups(const Mesh& mesh, std::size_t size) : group_(mesh.triangles().size(), kNone) {
  for (std::size_t t = 0; t < group_.size(); ++t)
    if (group_[t] == kNone) grow_from(mesh, t, size);
  connect(mesh);
}

/// Breadth-first, so that groups are about as wide as long.
void TriangleGroups::grow_from(const Mesh& mesh, std::size_t triangle, std::size_t size) {
  const auto group = static_cast<std::uint32_t>(centres_.size());
  std::vector<std::size_t> members{triangle};
  group_[triangle] = group;
  Point sum(0, 0);
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Mesh::Triangle& here = mesh.triangles()[members[k]];
    sum += centre_of(mesh, here);
    for (const std::int32_t next : here.neighbour) {
      if (next == Mesh::kWall || members.size() == size) continue;
      std::uint32_t& of_next = group_[static_cast<std::size_t>(next)];
      if (of_next != kNone) continue;
      of_next = group;
      members.push_back(static_cast<std::size_t>(next));
    }
  }
  centres_.push_back(sum / static_cast<double>(members.size()));
}

void TriangleGroups::connect(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t t = 0; t < group_.size(); ++t)
    for (const std::int32_t next : mesh.triangles()[t].neighbour)
      if (next != Mesh::kWall && group_[static_cast<std::size_t>(next)] != group_[t])
        pairs.emplace_back(group_[t], group_[static_cast<std::size_t>(next)]);
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  first_.assign(count() + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++first_[from + 1];
    neighbours_.push_back(to);
  }
  for (std::size_t g = 0; g < count(); ++g) first_[g + 1] += first_[g];
}

}  // namespace oxturn
