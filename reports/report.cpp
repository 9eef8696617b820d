// reports/report.cpp
// Same results, same bytes: nothing of the clock, of the machine or of the folder's name goes in.
#include "reports/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "maps/formats.hpp"
#include "reports/groups.hpp"
#include "reports/pictures.hpp"
#include "reports/tables/tables.hpp"
#include "reports/text.hpp"
#include "base/files.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

std::string report_page(const Results& results, const Pictures& pictures) {
  const std::string suite = results.rows.empty() ? "" : results.rows.front().get("suite");
  std::string out = fmt::format("# oxturn: {}\n\n", escape_markdown(suite));
  const auto maps = by_map(results);
  out += fmt::format("{} runs: {} planner variants on {} problems. Pictures: [gallery.html](gallery.html).\n\n",
                     results.rows.size(), by_variant(results).size(), maps.size());
  out += "## Planners compared\n\n" + comparison_table(results);
  out +=
      "\nA run without a valid path counts as coverage 0. Length ratio (path over the shortest conceivable), overlap, "
      "revisits, turns and mission time are medians over runs with a valid path (ok or partial); plan_wall_s is the "
      "median over all runs that were timed.\n";
  if (const std::string tether = tether_table(results); !tether.empty())
    out += "\n## Tether\n\n" + tether +
           "\nOver the runs whose tether could be followed along their path, valid or not. Length ratio and crossings "
           "(the "
           "robot drives over its own line) are medians; within leash and entangled (the tether ends wound about "
           "something) "
           "are shares of these runs; worst over m is the farthest that any pulls it over its limit; most sharp is the "
           "largest share of a path that any drives against the tether's pull.\n";
  for (const RowGroup& map : maps) out += "\n## " + escape_markdown(map.title) + "\n\n" + map_table(map, pictures);
  return out;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make folder '" + folder.string() + "': " + error.message());
}

}  // namespace

Written write_report(const Results& results, const std::string& folder) {
  const fs::path root = folder;
  make_folder(root / "gallery");
  Written written;
  const auto write = [&](const std::string& name, const std::string& content) {
    const std::string file = (root / name).string();
    write_file(file, content);
    written.files.push_back(file);
  };
  const Pictures pictures = draw_runs(results, write);
  write("gallery.html", gallery_page(results, pictures));
  write("report.md", report_page(results, pictures));
  return written;
}

}  // namespace oxturn
