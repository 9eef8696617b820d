#include "algorithms/context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "geometry/trace.hpp"

namespace oxturn {
namespace {

/// A deadline in the clock's own ticks, at most a century ahead so that nothing overflows.
Context::Clock::time_point deadline_after(double wall_s) {
  constexpr double kLongest = 3e9;  // seconds
  const double seconds = std::clamp(wall_s, 0.0, kLongest);
  return Context::Clock::now() +
         std::chrono::duration_cast<Context::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Context::Context(std::uint64_t seed, double wall_s, Sinks sinks)
    : seed_(seed), wall_s_(wall_s), rng_(seed), deadline_(deadline_after(wall_s)), sinks_(std::move(sinks)) {}

void Context::begin() {
  if (begun_) return;
  begun_ = true;
  deadline_ = deadline_after(wall_s_);
  if (sinks_.begin) sinks_.begin();
}

void Context::peak_memory(double bytes) {
  if (sinks_.peak_memory) sinks_.peak_memory(bytes);
}

bool Context::cancelled() const { return cancelled_ || Clock::now() >= deadline_; }

double Context::seconds_left() const {
  if (cancelled_) return 0;
  return std::max(0.0, std::chrono::duration<double>(deadline_ - Clock::now()).count());
}

void Context::publish(const Path& path) {
  if (sinks_.publish) sinks_.publish(path);
}

void Context::progress(double fraction) {
  if (sinks_.progress) sinks_.progress(std::clamp(fraction, 0.0, 1.0));
}

void Context::trace(std::string name, std::vector<Polyline> lines) {
  if (sinks_.trace) sinks_.trace(Trace{std::move(name), std::move(lines)});
}

void Context::trace(std::string name, const Region& region) {
  if (!sinks_.trace) return;
  std::vector<Polyline> lines;
  for_each_ring(region, [&](const Ring& ring) {
    if (ring.empty()) return;
    lines.push_back(ring);
    lines.back().push_back(ring.front());
  });
  trace(std::move(name), std::move(lines));
}

void Context::promise(std::function<Region()> region) {
  if (sinks_.promise) sinks_.promise(std::move(region));
}

Context::Sinks Context::without_promise() const {
  Sinks sinks = sinks_;
  sinks.promise = {};
  return sinks;
}

Context::Sinks Context::traces_only() const {
  Sinks sinks;
  sinks.trace = sinks_.trace;
  return sinks;
}

void Context::record(const std::string& name, double value) {
  const auto good = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), good))
    throw std::invalid_argument(fmt::format(
        "a recorded figure is named '{}', expected at most 64 small letters, digits and underscores", name));
  if (sinks_.record) sinks_.record(name, value);
}

}  // namespace oxturn
