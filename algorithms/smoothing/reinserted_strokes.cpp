#include "algorithms/smoothing/reinserted_strokes.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace oxturn {
namespace {

constexpr double kNear = 2;   // tool widths and radii: the insertion of a stroke so near to a new one may cost less now
constexpr double kCheap = 8;  // radii and tool widths that such an insertion adds at most: many of these make one round
constexpr double kNone = std::numeric_limits<double>::infinity();

class Reinsertion {
 public:
  Reinsertion(const std::vector<Polyline>& left_out, KnownLinks& links, double width, DetourEffort& effort,
              const Context& context)
      : links_(links), width_(width), size_(width + links.space().radius()), effort_(effort), context_(context) {
    for (const Polyline& line : left_out) waiting_.push_back({line, bounding_box(line)});
  }

  std::vector<LinkedStroke> run(std::vector<LinkedStroke> driven) {
    bool any = true;
    while (any && !waiting_.empty() && !context_.cancelled()) {
      InsertedStrokes inserted(std::move(driven), links_, width_, effort_, context_);
      any = insert_cheapest(inserted) || insert_by_search(inserted);
      driven = inserted.take();
    }
    return driven;
  }

 private:
  struct Waiting {
    Polyline line;
    Box box;
    std::optional<double> added = std::nullopt;  // metres, besides its own; kNone: no simple link is free
    bool searched = false, inserted = false;
  };

  std::optional<InsertedStrokes::Insertion> looked_at(Waiting& stroke, const InsertedStrokes& inserted) const {
    auto insertion = inserted.insertion_of(stroke.line, false);
    stroke.added = insertion ? insertion->cost - length(stroke.line) : kNone;
    return insertion;
  }
  void insert_if_added_at_most(double most, Waiting& stroke, InsertedStrokes& inserted) const {
    auto insertion = looked_at(stroke, inserted);
    if (!insertion || *stroke.added > most) return;
    inserted.insert(std::move(*insertion));
    stroke.inserted = true;
  }

  /// The cheapest one, and all others that are cheap.
  bool insert_cheapest(InsertedStrokes& inserted) {
    for (Waiting& stroke : waiting_) {
      if (stroke.added) continue;
      if (context_.cancelled()) return false;
      looked_at(stroke, inserted);
    }
    std::ranges::stable_sort(waiting_, {}, [](const Waiting& stroke) { return *stroke.added; });
    if (*waiting_.front().added == kNone) return false;
    insert_if_added_at_most(kNone, waiting_.front(), inserted);
    const double cheap = kCheap * size_;
    for (std::size_t k = 1; k < waiting_.size() && *waiting_[k].added <= cheap; ++k)
      insert_if_added_at_most(cheap, waiting_[k], inserted);
    return forget_inserted();
  }

  bool insert_by_search(InsertedStrokes& inserted) {
    for (Waiting& stroke : waiting_) {
      if (context_.cancelled()) return false;
      if (std::exchange(stroke.searched, true)) continue;
      auto insertion = inserted.insertion_of(stroke.line, true);
      if (!insertion) continue;
      inserted.insert(std::move(*insertion));
      stroke.inserted = true;
      return forget_inserted();
    }
    return false;
  }

  /// And what is known of those near them. True if there were any.
  bool forget_inserted() {
    std::vector<Box> near;
    for (const Waiting& stroke : waiting_)
      if (stroke.inserted) near.push_back(stroke.box), near.back().grow(kNear * size_);
    std::erase_if(waiting_, [](const Waiting& stroke) { return stroke.inserted; });
    for (Waiting& stroke : waiting_)
      if (std::ranges::any_of(near, [&](const Box& box) { return box.overlaps(stroke.box); })) stroke.added.reset();
    return !near.empty();
  }

  KnownLinks& links_;
  double width_, size_;
  DetourEffort& effort_;
  const Context& context_;
  std::vector<Waiting> waiting_;
};

}  // namespace

std::vector<LinkedStroke> with_strokes(std::vector<LinkedStroke> driven, const std::vector<Polyline>& left_out,
                                       KnownLinks& links, double width, DetourEffort& effort, const Context& context) {
  return Reinsertion(left_out, links, width, effort, context).run(std::move(driven));
}

}  // namespace oxturn
