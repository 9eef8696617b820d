#include "reports/report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "base/files.hpp"
#include "reports/groups.hpp"
#include "reports/text.hpp"

namespace oxturn {

ReportTable comparison_table();
ReportTable tether_table();
ReportTable map_tables();

ReportTables built_in_tables() {
  return ReportTables("report table", {comparison_table(), tether_table(), map_tables()});
}

namespace {

namespace fs = std::filesystem;

std::string report_page(const Results& results, const ReportTables& tables) {
  const std::string suite = results.rows.empty() ? "" : results.rows.front().get("suite");
  std::string out = fmt::format("# oxturn: {}\n\n", escape_markdown(suite));
  out += fmt::format("{} runs: {} planner variants on {} problems. Pictures: [gallery.html](gallery.html).\n",
                     results.rows.size(), by_variant(results).size(), by_map(results).size());
  for (const ReportTable& table : tables)
    if (const std::string text = table.markdown(results); !text.empty())
      out += fmt::format("\n## {}\n\n{}", table.title, text);
  return out;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make folder '" + folder.string() + "': " + error.message());
}

}  // namespace

Written write_report(const Results& results, const ReportTables& tables, const std::string& folder) {
  const fs::path root = folder;
  make_folder(root);
  Written written;
  const auto write = [&](const std::string& name, const std::string& content) {
    const std::string file = (root / name).string();
    write_file(file, content);
    written.files.push_back(file);
  };
  std::error_code error;
  if (!results.pictures.empty() && !fs::equivalent(results.folder, root, error)) {
    make_folder(root / "pictures");
    for (const auto& [run, name] : results.pictures) write(name, read_file((fs::path(results.folder) / name).string()));
  }
  write("gallery.html", gallery_page(results));
  write("report.md", report_page(results, tables));
  return written;
}

}  // namespace oxturn
