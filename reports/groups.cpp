#include "reports/groups.hpp"

#include <array>
#include <map>
#include <set>

namespace oxturn {
namespace {

/// Groups by `key`, in order of first appearance.
template <class Key>
std::vector<RowGroup> grouped(const Results& results, Key key) {
  using K = decltype(key(results.rows.front()));
  std::vector<RowGroup> groups;
  std::map<K, std::size_t> index;
  for (const Row& row : results.rows) {
    const auto [it, fresh] = index.try_emplace(key(row), groups.size());
    if (fresh) groups.emplace_back();
    groups[it->second].rows.push_back(&row);
  }
  return groups;
}

}  // namespace

std::vector<RowGroup> by_variant(const Results& results) {
  auto groups = grouped(results, [](const Row& row) { return row.get("variant"); });
  for (RowGroup& group : groups) group.title = group.rows.front()->get("variant");
  return groups;
}

std::vector<RowGroup> by_map(const Results& results) {
  std::set<std::string> robots;
  std::map<std::string, std::set<std::string>> hashes;
  for (const Row& row : results.rows) {
    robots.insert(row.get("robot"));
    hashes[row.get("map")].insert(row.get("map_sha256"));
  }
  auto groups = grouped(results, [](const Row& row) {
    return std::array<std::string, 3>{row.get("map"), row.get("map_sha256"), row.get("robot")};
  });
  for (RowGroup& group : groups) {
    const Row& row = *group.rows.front();
    group.title = row.get("map");
    if (hashes[row.get("map")].size() > 1) group.title += " (" + row.get("map_sha256").substr(0, 8) + ")";
    if (robots.size() > 1) group.title += ", robot " + row.get("robot");
  }
  return groups;
}

}  // namespace oxturn
