#include "algorithms/tour/open_tour.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "algorithms/tour/point_grid.hpp"

namespace oxturn {
namespace {
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kLookAt = 24;  // candidates by straight distance for the nearest by path
constexpr std::size_t kNeighbours = 10;
}  // namespace

// Ports: the entry of pattern q of element e is port first[e] + q; the exit of a pattern is the entry of its
// reverse. The start is the last port.
struct OpenTour::Impl {
  const std::vector<TourElement>& elements;
  const Connector& connector;
  std::vector<std::size_t> first, owner;
  std::vector<Point> ports;  // without the start
  Point start;
  std::size_t start_port;
  // Looked up only, never walked. Negative: no path as short as that (minus a limit that was tried).
  mutable std::unordered_map<std::uint64_t, double> known;
  mutable std::size_t searches = 0;

  Impl(const Point& s, const std::vector<TourElement>& e, const Connector& c) : elements(e), connector(c), start(s) {
    for (std::size_t i = 0; i < e.size(); ++i) {
      first.push_back(ports.size());
      for (const Pattern& p : e[i]) {
        ports.push_back(p.entry);
        owner.push_back(i);
      }
    }
    start_port = ports.size();
  }
  const Point& at(std::size_t port) const { return port == start_port ? start : ports[port]; }
  std::size_t entry(const TourStop& s) const { return first[s.element] + s.pattern; }
  std::size_t exit(const TourStop& s) const { return first[s.element] + elements[s.element][s.pattern].reverse; }
  double own_cost(const TourStop& s) const { return elements[s.element][s.pattern].cost; }
  double bound(std::size_t a, std::size_t b) const { return distance(at(a), at(b)); }

  // Path length, or infinity if it is longer than `longest`: a limit keeps searches for hopeless moves short.
  double exact(std::size_t a, std::size_t b, double longest = kFar) const {
    if (a == b) return 0;
    const auto key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
    double& entry = known.emplace(key, 0.0).first->second;  // 0: nothing known yet
    if (entry > 0) return entry <= longest ? entry : kFar;
    if (entry < 0 && longest <= -entry) return kFar;
    if (longest < bound(a, b)) return kFar;
    ++searches;
    const double d = connector.length(at(std::min(a, b)), at(std::max(a, b)), longest);
    if (d < kFar)
      entry = std::max(d, 1e-300);
    else if (longest < kFar)
      entry = -longest;
    return d;
  }

  // The nearest by path of the ports that `visit` offers by rising straight distance.
  struct Best {
    std::size_t port = 0;
    double length = kFar;
  };
  void consider(Best& best, std::size_t from, std::size_t port) const {
    const double d = connector.length(at(from), at(port), best.length);
    if (d < best.length) best = {port, d};
  }
  // Searches with a limit that doubles: what is near on the map but far by path (behind a wall) costs no more than a
  // search of the neighbourhood.
  Best nearest_left(const PointGrid& grid, std::size_t from) const {
    Best best;
    std::size_t first_port = start_port;
    double farthest = 0;  // straight distance of the last candidate that counts
    std::size_t looked = 0;
    grid.visit(at(from), [&](std::size_t port, double straight) {
      if (first_port == start_port) first_port = port;
      farthest = straight;
      return ++looked < kLookAt;
    });
    const double nearest_by_line = bound(from, first_port);
    for (double limit = std::max(1.5 * nearest_by_line, farthest / 8); best.length == kFar && limit < kFar;
         limit *= 2) {
      best.length = limit;
      bool found = false;
      looked = 0;
      grid.visit(at(from), [&](std::size_t port, double straight) {
        if (straight >= best.length || looked++ >= kLookAt) return false;
        const double before_it = best.length;
        consider(best, from, port);
        found = found || best.length < before_it;
        return true;
      });
      if (!found) best.length = kFar;
      if (limit == 0) limit = 1e-6;
      if (!found && limit > 1e12 * (1 + nearest_by_line)) break;  // connected to nothing: take the first
    }
    if (best.length == kFar) best = {first_port, kFar};
    return best;
  }
  void take(PointGrid& grid, std::size_t element) const {
    for (std::size_t q = 0; q < elements[element].size(); ++q) grid.remove(first[element] + q);
  }
  TourStop stop_at(std::size_t port) const { return {owner[port], port - first[owner[port]]}; }
};

OpenTour::OpenTour(const Point& start, const std::vector<TourElement>& elements, const Connector& connector)
    : impl_(std::make_unique<Impl>(start, elements, connector)) {}
OpenTour::~OpenTour() = default;

std::vector<TourStop> OpenTour::nearest(Context& context) const {
  const Impl& m = *impl_;
  std::vector<TourStop> tour;
  PointGrid grid(m.ports);
  std::size_t at = m.start_port;
  while (grid.remaining() > 0 && !context.cancelled()) {
    const TourStop next = m.stop_at(m.nearest_left(grid, at).port);
    m.take(grid, next.element);
    tour.push_back(next);
    at = m.exit(next);
  }
  return tour;
}

std::vector<TourStop> OpenTour::depth_first(const std::vector<std::vector<std::size_t>>& neighbours,
                                            Context& context) const {
  const Impl& m = *impl_;
  std::vector<TourStop> tour;
  PointGrid grid(m.ports);
  std::vector<bool> visited(m.elements.size(), false);
  std::vector<std::size_t> stack;
  std::size_t at = m.start_port;
  while (grid.remaining() > 0 && !context.cancelled()) {
    Impl::Best best;
    std::size_t any = m.start_port;
    while (!stack.empty() && any == m.start_port) {
      std::vector<std::pair<double, std::size_t>> offers;
      for (const std::size_t n : neighbours[stack.back()])
        if (!visited[n])
          for (std::size_t q = 0; q < m.elements[n].size(); ++q)
            offers.push_back({m.bound(at, m.first[n] + q), m.first[n] + q});
      std::sort(offers.begin(), offers.end());
      if (offers.empty())
        stack.pop_back();
      else
        any = offers.front().second;
      for (const auto& [straight, port] : offers) {
        if (straight >= best.length) break;
        m.consider(best, at, port);
      }
    }
    if (any == m.start_port)
      best = m.nearest_left(grid, at);
    else if (best.length == kFar)
      best.port = any;
    const TourStop next = m.stop_at(best.port);
    visited[next.element] = true;
    m.take(grid, next.element);
    stack.push_back(next.element);
    tour.push_back(next);
    at = m.exit(next);
  }
  return tour;
}

double OpenTour::cost(const std::vector<TourStop>& tour) const {
  const Impl& m = *impl_;
  double sum = 0;
  std::size_t at = m.start_port;
  for (const TourStop& s : tour) {
    sum += m.exact(at, m.entry(s)) + m.own_cost(s);
    at = m.exit(s);
  }
  return sum;
}

void OpenTour::choose_patterns(std::vector<TourStop>& tour) const {
  const Impl& m = *impl_;
  if (tour.empty()) return;
  std::vector<std::vector<std::size_t>> from(tour.size());
  std::vector<double> reach{0.0};
  std::vector<std::size_t> exits{m.start_port};
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const std::size_t e = tour[i].element;
    std::vector<double> next(m.elements[e].size(), kFar);
    from[i].assign(next.size(), 0);
    for (std::size_t q = 0; q < next.size(); ++q) {
      const std::size_t port = m.first[e] + q;
      for (std::size_t k = 0; k < exits.size(); ++k) {
        const double own = m.elements[e][q].cost;
        if (reach[k] + m.bound(exits[k], port) + own >= next[q]) continue;
        const double d = reach[k] + m.exact(exits[k], port, next[q] - reach[k] - own) + own;
        if (d < next[q]) {
          next[q] = d;
          from[i][q] = k;
        }
      }
    }
    exits.clear();
    for (std::size_t q = 0; q < next.size(); ++q) exits.push_back(m.exit({e, q}));
    reach = next;
  }
  std::size_t q = static_cast<std::size_t>(std::min_element(reach.begin(), reach.end()) - reach.begin());
  for (std::size_t i = tour.size(); i-- > 0;) {
    tour[i].pattern = q;
    q = from[i][q];
  }
}

void OpenTour::improve(std::vector<TourStop>& tour, Context& context) const {
  const Impl& m = *impl_;
  const std::size_t n = tour.size();
  if (n < 2) return;
  // Neighbour lists of ports, other elements only.
  std::vector<std::array<std::uint32_t, kNeighbours>> near(m.ports.size());
  std::vector<std::uint8_t> near_count(m.ports.size(), 0);
  {
    const PointGrid grid(m.ports);
    for (std::size_t p = 0; p < m.ports.size(); ++p)
      grid.visit(m.ports[p], [&](std::size_t other, double) {
        if (m.owner[other] != m.owner[p]) near[p][near_count[p]++] = static_cast<std::uint32_t>(other);
        return near_count[p] < kNeighbours;
      });
  }
  std::vector<std::size_t> place(m.elements.size(), n);
  const auto renumber = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) place[tour[i].element] = i;
  };
  renumber(0, n);
  const auto exit_of = [&](std::size_t i) { return i == 0 ? m.start_port : m.exit(tour[i - 1]); };  // before stop i
  const auto flipped = [&](TourStop s) {
    s.pattern = m.elements[s.element][s.pattern].reverse;
    return s;
  };
  const std::size_t most_searches = m.searches + std::min<std::size_t>(4000 + 6 * n, 12000);
  constexpr double kGain = 1e-9;

  // Turns round stops i..j.
  const auto try_two_opt = [&](std::size_t i, std::size_t j) {
    const std::size_t before_i = exit_of(i), in = m.entry(tour[i]), out = m.exit(tour[j]);
    double removed = m.exact(before_i, in), lower = m.bound(before_i, out);
    if (j + 1 < n) {
      removed += m.exact(out, m.entry(tour[j + 1]));
      lower += m.bound(in, m.entry(tour[j + 1]));
    }
    if (removed - lower <= kGain) return false;
    const double other = j + 1 < n ? m.bound(in, m.entry(tour[j + 1])) : 0;
    double added = m.exact(before_i, out, removed - other);
    if (j + 1 < n && added < kFar) added += m.exact(in, m.entry(tour[j + 1]), removed - added);
    if (removed - added <= kGain) return false;
    std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(i), tour.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    for (std::size_t k = i; k <= j; ++k) tour[k] = flipped(tour[k]);
    renumber(i, j + 1);
    return true;
  };
  // Moves stops i..i+count-1 to between `to` - 1 and `to` (`to` outside the stops), in any pattern if single,
  // else either way round.
  const auto try_move = [&](std::size_t i, std::size_t count, std::size_t to) {
    const std::size_t last = i + count - 1;
    if (to >= i && to <= last + 1) return false;
    double removed = m.exact(exit_of(i), m.entry(tour[i]));
    double closed = 0;
    if (last + 1 < n) { removed += m.exact(m.exit(tour[last]), m.entry(tour[last + 1])); }
    const std::size_t left = exit_of(to);
    const bool has_right = to < n;
    const std::size_t right = has_right ? m.entry(tour[to]) : m.start_port;
    if (has_right) removed += m.exact(left, right);
    if (last + 1 < n) {
      if (removed - m.bound(exit_of(i), m.entry(tour[last + 1])) <= kGain) return false;
      closed = m.exact(exit_of(i), m.entry(tour[last + 1]), removed);
      if (removed - closed <= kGain) return false;
    }
    std::vector<std::pair<TourStop, TourStop>> ways;  // first and last stop when driven that way
    if (count == 1) {
      for (std::size_t q = 0; q < m.elements[tour[i].element].size(); ++q) {
        const TourStop s{tour[i].element, q};
        ways.push_back({s, s});
      }
    } else {
      ways.push_back({tour[i], tour[last]});
      ways.push_back({flipped(tour[last]), flipped(tour[i])});
    }
    double best = removed - kGain;
    std::size_t chosen = ways.size();
    for (std::size_t v = 0; v < ways.size(); ++v) {
      const auto& [head, tail] = ways[v];
      const double own = count == 1 ? m.own_cost(head) - m.own_cost(tour[i]) : 0;
      const double other = has_right ? m.bound(m.exit(tail), right) : 0;
      if (closed + own + m.bound(left, m.entry(head)) + other >= best) continue;
      double added = closed + own + m.exact(left, m.entry(head), best - closed - own - other);
      if (has_right && added < best) added += m.exact(m.exit(tail), right, best - added);
      if (added < best) {
        best = added;
        chosen = v;
      }
    }
    if (chosen == ways.size()) return false;
    std::vector<TourStop> moved(tour.begin() + static_cast<std::ptrdiff_t>(i),
                                tour.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    if (count == 1) {
      moved[0] = ways[chosen].first;
    } else if (chosen == 1) {
      std::reverse(moved.begin(), moved.end());
      for (TourStop& s : moved) s = flipped(s);
    }
    tour.erase(tour.begin() + static_cast<std::ptrdiff_t>(i), tour.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const std::size_t at = to > last ? to - count : to;
    tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(at), moved.begin(), moved.end());
    renumber(std::min(i, at), std::min(n, std::max(last, at + count) + 1));
    return true;
  };
  const auto step = [&](std::size_t i) {
    const std::size_t before_i = exit_of(i), in = m.entry(tour[i]);
    const double here = m.exact(before_i, in);
    // A nearer exit than the one we come from: turn round what lies between, or move this stop there.
    for (std::size_t k = 0; before_i != m.start_port && k < near_count[before_i]; ++k) {
      const std::size_t port = near[before_i][k];
      if (m.bound(before_i, port) >= here) break;
      const std::size_t j = place[m.owner[port]];
      if (j < n && j >= i && port == m.exit(tour[j]) && try_two_opt(i, j)) return true;
    }
    for (std::size_t k = 0; k < near_count[in]; ++k) {
      const std::size_t port = near[in][k];
      if (m.bound(in, port) >= here) break;
      const std::size_t j = place[m.owner[port]];
      if (j < n && j > i && port == m.entry(tour[j]) && try_two_opt(i, j - 1)) return true;
    }
    for (std::size_t count = 1; count <= 3 && i + count <= n; ++count) {
      const std::size_t ends[2] = {in, m.exit(tour[i + count - 1])};
      for (const std::size_t end : ends)
        for (std::size_t k = 0; k < near_count[end]; ++k) {
          const std::size_t j = place[m.owner[near[end][k]]];
          if (j >= n) continue;
          if (try_move(i, count, j) || try_move(i, count, j + 1)) return true;
        }
    }
    return false;
  };
  bool again = true;
  for (int round = 0; again && round < 8; ++round) {
    again = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (m.searches >= most_searches || context.cancelled()) return;
      if (step(i)) again = true;
    }
  }
}

}  // namespace oxturn
