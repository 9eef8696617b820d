#include "geometry/mesh/straight_skeleton.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Straight_skeleton_builder_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/mesh/cgal_guard.hpp"
#include "geometry/mesh/split_candidates.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Skeleton = CGAL::Straight_skeleton_2<Kernel>;
using Traits = CGAL::Straight_skeleton_builder_traits_2<Kernel>;

/// Makes CGAL's builder one that looks for splits near by. CGAL tests each reflex vertex against all edges, and looks
/// at all reflex vertices after each event: O(n^2). To compare two events, whose times it keeps, it first converts all
/// edges that they come from. The members specialised below do none of this; the skeleton is the same.
struct NearBy : CGAL::Dummy_straight_skeleton_builder_2_visitor<Skeleton> {
  mutable std::optional<SplitCandidates> candidates;
};
using Builder = CGAL::Straight_skeleton_builder_2<Traits, Skeleton, NearBy>;

constexpr double kClearly = 1e-8;  // of a time: by which two differ certainly
using Trisegment = Traits::Trisegment_2_ptr;

Point to_point(const Kernel::Point_2& p) { return {p.x(), p.y()}; }

template <class To>
using Converter = CGAL::CGAL_SS_i::SS_converter<CGAL::Cartesian_converter<Kernel, To>>;

/// Three lines, none of them on another: their event depends on nothing else.
bool is_normal(const Trisegment& event) { return event->collinearity() == CGAL::TRISEGMENT_COLLINEARITY_NONE; }

/// When an event happens, with the numbers of a kernel; nullptr if more than three lines decide it.
template <class To, class Caches>
auto time_of(Caches& caches, const Trisegment& event) -> decltype(&caches.mTime_cache.Get(0)) {
  if (!caches.mTime_cache.IsCached(event->id())) {
    if (!is_normal(event)) return nullptr;
    CGAL::CGAL_SS_i::compute_offset_lines_isec_timeC2(Converter<To>().cvt_single_trisegment(event), caches.mTime_cache,
                                                      caches.mCoeff_cache);
  }
  return &caches.mTime_cache.Get(event->id());
}

/// The order of two events as CGAL compares them, with the numbers of a kernel. Unknown if rounding leaves it open.
template <class To, class Caches>
CGAL::Uncertain<CGAL::Comparison_result> compare_times(Caches& caches, const Trisegment& a, const Trisegment& b) {
  const auto unknown = CGAL::Uncertain<CGAL::Comparison_result>::indeterminate();
  if (!time_of<To>(caches, a)) return unknown;
  const auto* bt = time_of<To>(caches, b);
  const auto* at = time_of<To>(caches, a);  // again: the cache may have moved
  if (!bt || !*at || !*bt) return unknown;
  const auto first = (*at)->to_quotient(), second = (*bt)->to_quotient();
  const bool positive =
      CGAL::certainly(CGAL::certified_is_positive(first)) && CGAL::certainly(CGAL::certified_is_positive(second));
  return positive ? CGAL::certified_compare(first, second) : unknown;
}

/// Certainly, do two events lie at different points?
template <class To, class Caches>
bool apart(Caches& caches, const Trisegment& a, const Trisegment& b) {
  if (!is_normal(a) || !is_normal(b)) return false;
  const auto at = [&](const Trisegment& event) {
    return CGAL::CGAL_SS_i::construct_offset_lines_isecC2(Converter<To>().cvt_single_trisegment(event),
                                                          caches.mCoeff_cache);
  };
  const auto p = at(a), q = at(b);
  return p && q &&
         (CGAL::certainly_not(CGAL::certified_is_equal(p->x(), q->x())) ||
          CGAL::certainly_not(CGAL::certified_is_equal(p->y(), q->y())));
}

}  // namespace
}  // namespace oxturn

namespace CGAL {

template <>
Comparison_result oxturn::Builder::CompareEvents(Trisegment_2_ptr const& a, Trisegment_2_ptr const& b) const {
  {
    const Traits::Protector rounding;
    const auto known = oxturn::compare_times<oxturn::Kernel::Approximate_kernel>(mTraits.mApproximate_traits, a, b);
    if (is_certain(known)) return get_certain(known);
  }
  const auto known = oxturn::compare_times<oxturn::Kernel::Exact_kernel>(mTraits.mExact_traits, a, b);
  if (is_certain(known)) return get_certain(known);
  return Compare_ss_event_times_2(mTraits)(a, b);
}

/// Of edges that are parallel in pairs many events have the same time, but few the same point.
template <>
bool oxturn::Builder::AreEventsSimultaneous(Trisegment_2_ptr const& a, Trisegment_2_ptr const& b) const {
  if (CompareEvents(a, b) != EQUAL) return false;
  {
    const Traits::Protector rounding;
    if (oxturn::apart<oxturn::Kernel::Approximate_kernel>(mTraits.mApproximate_traits, a, b)) return false;
  }
  return Are_ss_events_simultaneous_2(mTraits)(a, b);
}

/// Of splits that tie, those tried first; CGAL takes the one at the lower address, which memory's use decides.
template <>
bool oxturn::Builder::Split_event_compare::operator()(EventPtr const& a, EventPtr const& b) const {
  Comparison_result order = EQUAL;
  if (mBuilder->AreEventsSimultaneous(a, b)) {
    mBuilder->GetVertexData(mV).mHasSimultaneousEvents = true;
    order = mBuilder->CompareEventsSupportAngles(a, b);
  } else {
    order = mBuilder->CompareEvents(a, b);
  }
  return order == EQUAL ? a->trisegment()->id() < b->trisegment()->id() : order == LARGER;
}

/// Events in the queue have a time that is certain to a tenth of kClearly, or none, until they happen.
template <>
void oxturn::Builder::InsertEventInPQ(EventPtr event) {
  double time = std::numeric_limits<double>::quiet_NaN();
  {
    const Traits::Protector rounding;
    const auto* known =
        oxturn::time_of<oxturn::Kernel::Approximate_kernel>(mTraits.mApproximate_traits, event->trisegment());
    if (known && *known) {
      const auto within = (*known)->to_nt();
      if (within.inf() > 0 && within.sup() - within.inf() < oxturn::kClearly / 10 * within.inf()) time = within.inf();
    }
  }
  event->SetTimeAndPoint(time, {0, 0});
  mPQ.push(event);
}

/// The queue of all events is far larger than caches of processors: what is in the events themselves decides first.
template <>
bool oxturn::Builder::Event_compare::operator()(EventPtr const& a, EventPtr const& b) const {
  const double at = a->time(), bt = b->time();
  if (std::abs(at - bt) > oxturn::kClearly * std::max(at, bt)) return at > bt;
  return mBuilder->CompareEvents(a, b) == LARGER;
}

template <>
void oxturn::Builder::CollectSplitEvents(Vertex_handle node, Triedge const& previous) {
  const auto number = [](Halfedge_handle border) { return static_cast<std::size_t>(border->id()) / 2; };
  if (!mVisitor.candidates) {
    std::vector<oxturn::SplitCandidates::Edge> edges(mContourHalfedges.size());
    for (const Halfedge_handle h : mContourHalfedges)
      edges[number(h)] = {oxturn::to_point(h->opposite()->vertex()->point()), oxturn::to_point(h->vertex()->point())};
    mVisitor.candidates.emplace(std::move(edges));
  }
  const Triedge triedge = GetVertexTriedge(node);
  const Halfedge_handle left = triedge.e0(), right = triedge.e1();
  Halfedge_handle_vector near;
  for (const std::uint32_t e :
       mVisitor.candidates->find(number(left), number(right), oxturn::to_point(node->point()), node->time()))
    near.push_back(mContourHalfedges[e]);
  ComputeUpperBoundForValidSplitEvents(GetPrevInLAV(node), node, GetNextInLAV(node), near.begin(), near.end());
  for (const Halfedge_handle opposite : near) {
    const Triedge event(left, right, opposite);
    if (opposite != left && opposite != right && event != previous) CollectSplitEvent(node, event);
  }
}

/// After an event only the vertices that it made, and the one that waited for it, have a next split.
template <>
void oxturn::Builder::Propagate() {
  std::size_t known = 0;
  const auto insert_next = [&](Vertex_handle v) {
    if (!IsProcessed(v)) InsertNextSplitEventInPQ(v);
  };
  for (;;) {
    for (; known < mReflexVertices.size(); ++known) insert_next(mReflexVertices[known]);
    if (mPQ.empty()) return;
    const EventPtr event = PopEventFromPQ();
    const bool split = event->type() != Event::cEdgeEvent;
    if (split) AllowNextSplitEvent(event->seed0());
    if (!IsProcessed(event)) {
      SetEventTimeAndPoint(*event);
      switch (event->type()) {
        case Event::cEdgeEvent:
          HandleEdgeEvent(event);
          break;
        case Event::cSplitEvent:
          HandleSplitOrPseudoSplitEvent(event);
          break;
        case Event::cPseudoSplitEvent:
          HandlePseudoSplitEvent(event);
          break;
      }
    }
    if (split) insert_next(event->seed0());
  }
}

}  // namespace CGAL

namespace oxturn {
namespace {

void enter(Builder& builder, const Ring& ring) {
  std::vector<Kernel::Point_2> points;
  for (const Point& p : ring) points.emplace_back(p.x(), p.y());
  builder.enter_contour(points.begin(), points.end());
}

/// The position of each of CGAL's items in their order, by the items' numbers.
template <class Items>
std::vector<std::size_t> positions(Items begin, Items end) {
  std::vector<std::size_t> positions;
  std::size_t position = 0;
  for (auto item = begin; item != end; ++item) {
    const auto id = static_cast<std::size_t>(item->id());
    if (positions.size() <= id) positions.resize(id + 1);
    positions[id] = position++;
  }
  return positions;
}

StraightSkeleton converted(const Skeleton& skeleton) {
  StraightSkeleton result;
  const std::vector<std::size_t> node = positions(skeleton.vertices_begin(), skeleton.vertices_end()),
                                 face = positions(skeleton.faces_begin(), skeleton.faces_end());
  for (auto v = skeleton.vertices_begin(); v != skeleton.vertices_end(); ++v)
    result.nodes.push_back({to_point(v->point()), v->time()});
  for (auto f = skeleton.faces_begin(); f != skeleton.faces_end(); ++f) {
    const auto edge = f->halfedge()->defining_contour_edge();
    const Point a = to_point(edge->opposite()->vertex()->point()), b = to_point(edge->vertex()->point());
    result.directions.push_back((b - a).normalized());
  }
  const auto at = [](const std::vector<std::size_t>& positions, int id) {
    return positions[static_cast<std::size_t>(id)];
  };
  for (auto h = skeleton.halfedges_begin(); h != skeleton.halfedges_end(); ++h) {
    const auto o = h->opposite();
    if (!h->is_bisector() || h->id() > o->id()) continue;
    std::size_t low = at(node, o->vertex()->id()), high = at(node, h->vertex()->id());
    if (result.nodes[low].time > result.nodes[high].time) std::swap(low, high);
    result.arcs.push_back({low, high, {at(face, h->face()->id()), at(face, o->face()->id())}});
  }
  return result;
}

}  // namespace

StraightSkeleton straight_skeleton(const Polygon& polygon) {
  StraightSkeleton result;
  cgal_guarded("the straight skeleton", [&] {
    const NearBy near_by;
    Builder builder(boost::none, Traits(), near_by);
    enter(builder, polygon.outer);
    for (const Ring& hole : polygon.holes) enter(builder, hole);
    const auto skeleton = builder.construct_skeleton();
    if (!skeleton) throw std::runtime_error("no result");
    result = converted(*skeleton);
  });
  return result;
}

}  // namespace oxturn
