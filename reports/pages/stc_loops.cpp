// docs/stc-loops.md: coverage next to walls, of stc, of the slides as they stand, and of what is hung on beside them.
//
// Decisions   1. The slides as they stand are the variant that says so in full: no fill, their epsilon on this robot,
//                every loop there and back. What is left out is the default.
//             2. A run without a valid path has no figures; its outcome stands in their place.
#include <fmt/format.h>

#include <algorithm>

#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

struct Column {
  const char* variant;
  const char* title;
};
constexpr Column kColumns[] = {{"stc", "stc"},
                               {"stc-loops[close_loops=false;epsilon=0.05;fill=none]", "slides"},
                               {"stc-loops[fill=none]", "fill=none"},
                               {"stc-loops[fill=cells]", "fill=cells"},
                               {"stc-loops", "stc-loops"}};

const Row* find(const RowGroup& map, const Column& column) {
  for (const Row* row : map.rows)
    if (row->get("variant") == column.variant) return row;
  return nullptr;
}

std::string figure(const Row* row, const char* name, int digits) {
  if (row == nullptr) return "";
  return valid_path(*row) ? fixed(row->number(name), digits) : row->get("outcome");
}

std::string table(const std::vector<RowGroup>& maps, const char* name, int digits) {
  std::vector<std::string> head{"map"};
  std::string align = "l";
  for (const Column& column : kColumns) {
    head.emplace_back(column.title);
    align += 'r';
  }
  std::vector<std::vector<std::string>> rows;
  for (const RowGroup& map : maps) {
    std::vector<std::string> row{escape_markdown(map.title)};
    for (const Column& column : kColumns) row.push_back(figure(find(map, column), name, digits));
    rows.push_back(std::move(row));
  }
  return markdown_table(align, head, rows);
}

std::string summary(const std::vector<RowGroup>& maps) {
  std::vector<std::vector<std::string>> rows;
  for (const Column& column : kColumns) {
    std::vector<double> coverage, ratio;
    std::size_t runs = 0, enough = 0, above = 0;
    for (const RowGroup& map : maps) {
      const Row *row = find(map, column), *before = find(map, kColumns[0]);
      if (row == nullptr) continue;
      ++runs;
      if (!valid_path(*row)) continue;
      const auto share = row->number("coverage"), old = before == nullptr ? std::nullopt : before->number("coverage");
      if (share) coverage.push_back(*share);
      enough += share && *share >= 0.99;
      above += share && (!old || *share > *old);
      if (const auto r = row->number("length_ratio")) ratio.push_back(*r);
    }
    const auto least =
        coverage.empty() ? std::nullopt : std::optional<double>(*std::min_element(coverage.begin(), coverage.end()));
    const auto of = [&](std::size_t part) { return fmt::format("{} of {}", part, runs); };
    rows.push_back({escape_markdown(column.title), of(coverage.size()), fixed(least, 4), fixed(median(coverage), 4),
                    of(enough), of(above), fixed(median(ratio), 3)});
  }
  return markdown_table(
      "lrrrrrr", {"variant", "valid", "least coverage", "median", "0.99 or more", "above stc", "length ratio"}, rows);
}

}  // namespace

std::string stc_loops_page(const Results& results) {
  const std::vector<RowGroup> maps = by_map(results);
  return "What `stc` leaves bare next to walls, and what loops round the obstacles make of it. `slides`: the loops as "
         "the "
         "slides have them (`fill = none`, `epsilon = 0.05`, which is 0.01 m on this robot, `close_loops = false`). "
         "`fill=none`: the same a fifth as far off the walls, unbroken loops driven round once. `fill=cells`: bare "
         "sub-cells hung on the tree as well. `stc-loops`: the default, `fill = spots`, bare spots as well.\n\n" +
         summary(maps) +
         "\n## Step by step\n\nMade by `scripts/stages` on a room of its own; two pillars are too near to each other "
         "and "
         "one to the wall.\n\n"
         "| | |\n|---|---|\n"
         "| ![stc](pictures/stc-loops/1-stc.svg) | ![bisectors](pictures/stc-loops/2-bisectors.svg) |\n"
         "| `stc`: bare areas around obstacles and border | bisectors |\n"
         "| ![nodes](pictures/stc-loops/3-nodes.svg) | ![loops](pictures/stc-loops/4-loops.svg) |\n"
         "| nodes along the edges | nodes connected to loops; the invalid ones stand out |\n"
         "| ![broken loops](pictures/stc-loops/5-broken-loops.svg) | "
         "![merged tree](pictures/stc-loops/6-merged-tree.svg) |\n"
         "| broken loops: connected components | merged spanning tree |\n"
         "| ![slides](pictures/stc-loops/7-slides.svg) | ![filled](pictures/stc-loops/8-filled.svg) |\n"
         "| the way round it, as on the slides | the default: bare spots as branches |\n\n"
         "## Coverage\n\n" +
         table(maps, "coverage", 4) + "\n## Length of the path, m\n\n" + table(maps, "path_m", 1);
}

}  // namespace oxturn
