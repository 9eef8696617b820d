// gallery.html: the pictures side by side.
#include <fmt/format.h>

#include "maps/picture.hpp"
#include "reports/groups.hpp"
#include "reports/report.hpp"
#include "reports/text.hpp"

namespace oxturn {
namespace {

constexpr const char* kStyle = R"css(
:root { color-scheme: light; }
body { margin: 1.5rem; font: 15px/1.4 system-ui, sans-serif; color: #222; background: #f6f7f8; }
h1 { font-size: 1.4rem; margin: 0 0 .2rem; }
p { margin: .2rem 0 1rem; max-width: 60rem; color: #555; }
.scroll { overflow-x: auto; }
table { border-collapse: separate; border-spacing: .5rem; }
thead th { position: sticky; top: 0; background: #f6f7f8; font-weight: 600; padding: .3rem; z-index: 1; }
tbody th { text-align: left; vertical-align: top; padding: .4rem .6rem .4rem 0; min-width: 6rem; max-width: 12rem;
           overflow-wrap: break-word; }
td { vertical-align: top; padding: 0; }
figure { margin: 0 0 .5rem; width: 17rem; background: #fff; border: 1px solid #d8dbdf; border-radius: 4px;
         overflow: hidden; }
figure img { display: block; width: 100%; height: auto; }
.none { display: flex; align-items: center; justify-content: center; height: 8rem; background: #eceef0;
        color: #777; }
figcaption { padding: .4rem .6rem; font-size: .85rem; font-variant-numeric: tabular-nums;
             overflow-wrap: anywhere; }
.badge { display: inline-block; padding: 0 .45rem; border-radius: 3px; color: #fff; background: #b3261e; }
.badge.ok { background: #1a7f37; }
.badge.partial { background: #9a6700; }
.reason { display: block; color: #8a1c16; margin-top: .2rem; }
)css";

std::string figure(const Row& row, const Results& results, bool show_repeat) {
  const std::string outcome = to_text(row.outcome());
  const std::string title = row.get("variant") + " on " + row.get("map") + ": " + outcome;
  std::string out = fmt::format("<figure id=\"{}\">", escape_xml(row.get("run_id")));
  if (const auto it = results.pictures.find(row.get("run_id")); it != results.pictures.end()) {
    const std::string link = escape_xml(escape_url(it->second));
    out += fmt::format("<a href=\"{0}\"><img loading=\"lazy\" src=\"{0}\" alt=\"{1}\"></a>", link, escape_xml(title));
  } else {
    out += "<div class=\"none\">no path</div>";
  }
  out += fmt::format("<figcaption><span class=\"badge {0}\">{0}</span>", outcome);
  if (const auto c = row.number("coverage")) out += fmt::format(" coverage {:.4f}", *c);
  const auto add = [&](const char* column, const char* label, const char* unit) {
    if (const auto value = row.number(column)) out += fmt::format(" &middot; {} {:.3g}{}", label, *value, unit);
  };
  add("path_m", "path", " m");
  add("mission_s", "mission", " s");
  add("overlap", "overlap", "");
  add("missed_pieces", "missed", "");
  add("plan_cpu_s", "CPU", " s");
  if (show_repeat) out += " &middot; repeat " + escape_xml(row.get("repeat"));
  if (row.outcome() != Outcome::ok && !row.get("reason").empty())
    out += "<span class=\"reason\">" + escape_xml(row.get("reason")) + "</span>";
  return out + "</figcaption></figure>\n";
}

}  // namespace

std::string gallery_page(const Results& results) {
  const std::string suite = results.rows.empty() ? "" : results.rows.front().get("suite");
  const auto variants = by_variant(results);
  std::string out = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>oxturn: {0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n"
      "<p>Every run, one picture: walls grey, the robot's path from blue to red, transit dashed, start green, end red. "
      "Swath light blue, darker where it overlaps; arrowheads show the direction. Missed pieces of the target are "
      "magenta; "
      "what else remains sand-coloured is smaller than they count. Click for the full size; "
      "the figures are in <a href=\"report.md\">report.md</a>.</p>\n"
      "<div class=\"scroll\"><table>\n<thead><tr><th></th>",
      escape_xml(suite), kStyle);
  for (const RowGroup& variant : variants) out += "<th scope=\"col\">" + escape_xml(variant.title) + "</th>";
  out += "</tr></thead>\n<tbody>\n";
  for (const RowGroup& map : by_map(results)) {
    out += "<tr><th scope=\"row\">" + escape_xml(map.title) + "</th>\n";
    for (const RowGroup& variant : variants) {
      std::vector<const Row*> cell;
      for (const Row* row : map.rows)
        if (row->get("variant") == variant.title) cell.push_back(row);
      out += "<td>";
      for (const Row* row : cell) out += figure(*row, results, cell.size() > 1);
      out += "</td>\n";
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table></div>\n</body>\n</html>\n";
}

}  // namespace oxturn
