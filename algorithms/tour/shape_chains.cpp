#include "algorithms/tour/shape_chains.hpp"

#include "base/disjoint_sets.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

/// The joints of one shape: at most two, at different ends.
struct Joint {
  std::size_t at;     // vertex of this shape
  ShapeVertex other;  // what it is joined to
};

class Joints {
 public:
  explicit Joints(const ShapeTour& drawing) : drawing_(drawing), joints_(drawing.shapes.size()) {
    DisjointSets groups(drawing.shapes.size());
    for (const auto& [a, b] : drawing.joined) {
      add(a, b);
      add(b, a);
      if (!groups.unite(a.shape, b.shape))
        throw_invalid("joining shapes {} and {} closes a cycle; remove one joint of it", named(a), named(b));
    }
  }
  bool is_end(std::size_t shape) const { return joints_[shape].size() == 1; }
  const std::vector<Joint>& of(std::size_t shape) const { return joints_[shape]; }

 private:
  void add(const ShapeVertex& a, const ShapeVertex& b) {
    if (a.shape >= drawing_.shapes.size())
      throw_invalid("shape {} is joined, but there are only {} shapes", a.shape, drawing_.shapes.size());
    const TourShape& shape = drawing_.shapes[a.shape];
    const std::size_t last = shape.points.size() - 1;
    if (shape.closed ? a.vertex > last : a.vertex != 0 && a.vertex != last)
      throw_invalid("shape {} is joined at vertex {}, expected {}", named(a), a.vertex,
                    shape.closed ? fmt::format("one of 0 to {}", last) : fmt::format("an end: 0 or {}", last));
    auto& joints = joints_[a.shape];
    if (joints.size() == 2)
      throw_invalid("shape {} is joined to shapes {}, {} and {}, expected at most two", named(a),
                    named(joints[0].other), named(joints[1].other), named(b));
    if (!joints.empty() && shape.closed && joints[0].at != a.vertex)
      throw_invalid("polygon {} is joined at vertices {} and {} (to shapes {} and {}), but is left where it is entered",
                    named(a), joints[0].at, a.vertex, named(joints[0].other), named(b));
    if (!joints.empty() && !shape.closed && last > 0 && joints[0].at == a.vertex)
      throw_invalid("shapes {} and {} are both joined to vertex {} of polyline {}, expected one at each end",
                    named(joints[0].other), named(b), a.vertex, named(a));
    joints.push_back({a.vertex, b});
  }

  std::string named(const ShapeVertex& v) const { return label(drawing_.shapes, v.shape); }

  const ShapeTour& drawing_;
  std::vector<std::vector<Joint>> joints_;
};

std::size_t other_end(const TourShape& shape, std::size_t vertex) {
  return shape.closed ? vertex : shape.points.size() - 1 - vertex;
}

}  // namespace

std::vector<ShapeChain> chains_of(const ShapeTour& drawing) {
  const Joints joints(drawing);
  std::vector<ShapeChain> chains;
  std::vector<bool> done(drawing.shapes.size(), false);
  for (std::size_t first = 0; first < drawing.shapes.size(); ++first) {
    if (done[first] || !joints.is_end(first)) continue;
    ShapeChain chain;
    std::size_t shape = first, entry = other_end(drawing.shapes[first], joints.of(first)[0].at);
    for (std::size_t from = shape;;) {
      done[shape] = true;
      chain.push_back({shape, entry, other_end(drawing.shapes[shape], entry)});
      const Joint* next = nullptr;
      for (const Joint& j : joints.of(shape))
        if (chain.size() == 1 || j.other.shape != from) next = &j;
      if (next == nullptr) break;
      from = shape;
      entry = next->other.vertex;
      shape = next->other.shape;
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace oxturn
