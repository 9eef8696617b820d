#include "reports/viewer/viewer.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "maps/picture.hpp"
#include "reports/viewer/page_parts.hpp"
#include "reports/viewer/viewer_json.hpp"

namespace oxturn {
namespace {

/// Appends the template up to `mark`, then `value`; the rest of the template is left in `rest`.
void fill(std::string& page, std::string_view& rest, std::string_view mark, std::string_view value) {
  const std::size_t at = rest.find(mark);
  if (at == std::string_view::npos) throw std::logic_error(fmt::format("page.html has no {}", mark));
  page += rest.substr(0, at);
  page += value;
  rest.remove_prefix(at + mark.size());
}

}  // namespace

std::string viewer_page(const ViewerData& data) {
  const std::string name = data.drawing_file.empty() ? data.problem.map().name : data.drawing_file;
  std::string page;
  std::string_view rest = viewer::kTemplate;
  fill(page, rest, "@TITLE@", escape_xml(name));
  fill(page, rest, "@STYLE@", viewer::kStyle);
  fill(page, rest, "@DATA@", viewer_json(data));
  fill(page, rest, "@SCRIPT@", viewer::kScript);
  page += rest;
  return page;
}

}  // namespace oxturn
