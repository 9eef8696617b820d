#include "maps/drawings/svg_document.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "maps/drawings/svg_style.hpp"

namespace oxturn::svg {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::size_t kDeepest = 256;

}  // namespace

Document::Document(const std::string& text, std::string file) : file_(std::move(file)) {
  if (text.size() > kMostBytes)
    throw_invalid("{} has {} MiB, expected at most {} MiB of SVG", file_, text.size() >> 20, kMostBytes >> 20);
  if (text.starts_with("\x1f\x8b")) throw_invalid("{} is compressed, expected plain SVG: decompress it first", file_);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw_invalid("{} is UTF-16, expected UTF-8: save it as UTF-8", file_);
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; ++at) line_ends_.push_back(at);
  // Always as UTF-8: another encoding would shift the positions of nodes; only their ids would differ.
  const pugi::xml_parse_result result =
      xml_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) throw_invalid("{}:{}: not XML: {}", file_, line_at(result.offset), result.description());
  if (!root()) throw_invalid("{} holds no element, expected an SVG document", file_);
  visit_all();
}

void Document::visit_all() {
  std::size_t nodes = 0;
  std::size_t depth = 0;
  std::vector<std::size_t> next_position(kDeepest + 2, 0);  // by depth: that of the next element
  for (pugi::xml_node node = root(); node;) {
    if (++nodes > kMostNodes) refuse(node, fmt::format("more than {} nodes", kMostNodes));
    if (depth > kDeepest) refuse(node, fmt::format("elements are nested deeper than {}", kDeepest));
    if (const pugi::xml_attribute id = node.attribute("id")) {
      Named& named = ids_[id.value()];
      if (named.count++ == 0) named.first = node;
    }
    if (node.type() == pugi::node_element) positions_[node.hash_value()] = next_position[depth]++;
    if (local_name(node) == "style") style_sheets_.push_back(node);
    if (node.first_child()) {
      node = node.first_child();
      next_position[++depth] = 0;
      continue;
    }
    while (node != root() && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node == root() ? pugi::xml_node() : node.next_sibling();
  }
}

std::size_t Document::line_at(std::ptrdiff_t offset) const {
  const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
  return static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, at) - line_ends_.begin()) + 1;
}
std::size_t Document::line(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

void Document::refuse(const pugi::xml_node& node, const std::string& sentence) const {
  throw_invalid("{}:{}: {}", file_, line(node), sentence);
}

pugi::xml_node Document::find(const std::string& id) const {
  const auto found = ids_.find(id);
  return found == ids_.end() ? pugi::xml_node() : found->second.first;
}

std::string Document::name_of(const pugi::xml_node& node) const {
  constexpr std::size_t kLongest = 200;
  if (const std::string id = node.attribute("id").value(); !id.empty() && id.size() <= kLongest)
    if (ids_.at(id).count == 1) return id;
  std::string name;
  for (pugi::xml_node at = node; at != root() && at; at = at.parent())
    name = std::to_string(positions_.at(at.hash_value())) + (name.empty() ? "" : "/") + name;
  return name;
}

}  // namespace oxturn::svg
