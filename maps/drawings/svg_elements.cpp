#include "maps/drawings/svg_elements.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "maps/drawings/svg_document.hpp"
#include "maps/drawings/svg_shapes.hpp"
#include "maps/drawings/svg_style.hpp"

namespace oxturn::svg {
namespace {

constexpr std::size_t kMostCommands = 1'000'000;
constexpr std::size_t kMostVisits = 2'000'000;   // of elements, through `use` too
constexpr std::size_t kMostBytes = 256'000'000;  // of attributes, through `use` too
constexpr std::size_t kMostUses = 100'000;
constexpr std::size_t kDeepestUse = 32;
constexpr std::size_t kMostRemarks = 100;
constexpr std::size_t kLongestName = 200;
constexpr double kMostCoordinate = 1e9;

/// What an element inherits from its parents.
struct Inherited {
  Affine to_px;
  Style style;
  Viewport viewport;
  std::string prefix;  // of names, inside a `use`
};

/// How an element takes part in a picture.
enum class Role { group, svg, choice, use, shape, hidden, unsupported, unknown };

Role role_of(std::string_view name) {
  static const std::map<std::string_view, Role> kRoles{
      {"g", Role::group}, {"a", Role::group}, {"svg", Role::svg}, {"switch", Role::choice}, {"use", Role::use}};
  // Definitions that show only where something refers to them, and descriptions.
  static const std::set<std::string_view> kHidden{
      "defs",           "symbol",        "style",    "title",     "desc",      "metadata", "linearGradient",
      "radialGradient", "pattern",       "clipPath", "mask",      "marker",    "filter",   "script",
      "view",           "color-profile", "font",     "font-face", "solidcolor"};
  static const std::set<std::string_view> kUnsupported{
      "text",    "image",         "foreignObject",    "video", "audio", "canvas", "iframe", "flowRoot",
      "animate", "animateMotion", "animateTransform", "set",   "mesh"};
  if (is_shape(name)) return Role::shape;
  if (const auto role = kRoles.find(name); role != kRoles.end()) return role->second;
  return kHidden.contains(name) ? Role::hidden : kUnsupported.contains(name) ? Role::unsupported : Role::unknown;
}

/// From a view box to a viewport of this size; SVG 1.1, 7.8.
Affine fitted(const std::array<double, 4>& box, double width, double height, std::string_view aspect) {
  double sx = width / box[2], sy = height / box[3];
  Scanner scan(aspect);
  scan.skip_blanks();
  std::string_view align = scan.word();
  if (align == "defer") scan.skip_blanks(), align = scan.word();
  scan.skip_blanks();
  const bool slice = scan.word() == "slice";
  if (align != "none") sx = sy = slice ? std::max(sx, sy) : std::min(sx, sy);
  const auto share = [&](std::string_view least, std::string_view most) {
    return align.find(least) != align.npos ? 0.0 : align.find(most) != align.npos ? 1.0 : 0.5;
  };
  const double x = share("xMin", "xMax") * (width - box[2] * sx), y = share("YMin", "YMax") * (height - box[3] * sy);
  return {sx, 0, 0, sy, x - box[0] * sx, y - box[1] * sy};
}

class Reader {
 public:
  Reader(const Document& document, bool widths_as_written)
      : document_(document), widths_as_written_(widths_as_written) {}

  Elements read() {
    for (const pugi::xml_node& node : document_.style_sheets()) add_style_sheet(node);
    visit(document_.root(), {{}, {}, {}, ""});
    if (unsaid_ > 0) out_.remarks.push_back(fmt::format("{}: {} more remarks", document_.file(), unsaid_));
    return std::move(out_);
  }

 private:
  void remark(const pugi::xml_node& node, const std::string& sentence) {
    const std::size_t line = document_.line(node);
    if (!said_.emplace(line, sentence).second) return;  // the same element, used again
    if (out_.remarks.size() < kMostRemarks)
      out_.remarks.push_back(fmt::format("{}:{}: {}", document_.file(), line, sentence));
    else
      ++unsaid_;
    if (said_.size() > kMostVisits) said_.clear();
  }
  void add_style_sheet(const pugi::xml_node& node) {
    std::string css;
    for (const pugi::xml_node& part : node.children()) css += part.value();
    try {
      sheet_.add(css, [&](const std::string& sentence) { remark(node, sentence); });
    } catch (const std::length_error& e) { document_.refuse(node, e.what()); }
  }

  /// Bounds what a document can expand to.
  void account(const pugi::xml_node& node) {
    for (const pugi::xml_attribute& attribute : node.attributes()) bytes_ += std::string_view(attribute.value()).size();
    if (++visits_ > kMostVisits || bytes_ > kMostBytes)
      document_.refuse(node, "the document expands to too many elements through `use`");
  }

  void visit(const pugi::xml_node& node, const Inherited& from) {
    if (node.type() != pugi::node_element) return;
    const std::string_view name = local_name(node);
    const Role role = name.empty() ? Role::hidden : role_of(name);  // elements of other namespaces do not show
    if (role == Role::hidden) return;
    account(node);
    Inherited own = from;
    own.style = style_of(node, from);
    if (!own.style.shown) return;
    if (const char* text = node.attribute("transform").value(); *text != '\0') {
      if (const auto transform = parse_transform(text))
        own.to_px = own.to_px * *transform;
      else
        return remark(node, fmt::format("its transform is not understood: {} is not drawn", name));
    }
    switch (role) {
      case Role::group:
        return visit_children(node, own);
      case Role::svg:
        return visit_viewport(node, node, own);
      case Role::choice:
        return visit_choice(node, own);
      case Role::use:
        return visit_use(node, own);
      case Role::shape:
        return add_shape(name, node, own);
      case Role::unsupported:
        return remark(node, fmt::format("{} is not supported and not drawn{}", name, hint(name)));
      default:
        return remark(node, fmt::format("unknown element '{}' is not drawn", printable(name.substr(0, 80))));
    }
  }
  static const char* hint(std::string_view name) { return name == "text" ? ": turn it into paths first" : ""; }

  Style style_of(const pugi::xml_node& node, const Inherited& from) {
    try {
      return sheet_.style_of(node, from.style, from.viewport.diagonal(),
                             [&](const std::string& sentence) { remark(node, sentence); });
    } catch (const std::length_error& e) { document_.refuse(node, e.what()); }
  }

  void visit_children(const pugi::xml_node& node, const Inherited& own) {
    for (const pugi::xml_node& child : node.children()) visit(child, own);
  }

  /// The first child that a reader of English sees and that needs no extension.
  void visit_choice(const pugi::xml_node& node, const Inherited& own) {
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element || local_name(child).empty()) continue;
      const pugi::xml_attribute language = child.attribute("systemLanguage");
      if (child.attribute("requiredExtensions") || local_name(child) == "foreignObject") continue;
      if (language && std::string_view(language.value()).find("en") == std::string_view::npos) continue;
      return visit(child, own);
    }
  }

  /// The children of an svg or symbol element, in its viewport. The size may come from the `use` that shows it.
  void visit_viewport(const pugi::xml_node& node, const pugi::xml_node& sized, Inherited own) {
    const bool outermost = node == document_.root();
    const std::optional<std::array<double, 4>> box = view_box(node);
    const Viewport whole = !outermost ? own.viewport : box ? Viewport{(*box)[2], (*box)[3]} : Viewport{300, 150};
    const auto size = [&](const char* name, double all) {
      const pugi::xml_node& by = sized.attribute(name) ? sized : node;
      return length_of(by, name, all, all);
    };
    const double width = size("width", whole.width), height = size("height", whole.height);
    if (!(width >= 0) || !(height >= 0)) return remark(node, "its width or height is negative or not understood");
    if (node == sized && !outermost) {
      const double x = length_of(node, "x", whole.width, 0), y = length_of(node, "y", whole.height, 0);
      if (!std::isfinite(x + y)) return remark(node, "its position is not understood: it is not drawn");
      own.to_px = own.to_px * Affine{1, 0, 0, 1, x, y};
    }
    own.viewport = box ? Viewport{(*box)[2], (*box)[3]} : Viewport{width, height};
    if (box) {
      if (width == 0 || height == 0 || (*box)[2] == 0 || (*box)[3] == 0) return;  // SVG: not drawn
      own.to_px = own.to_px * fitted(*box, width, height, node.attribute("preserveAspectRatio").value());
    }
    visit_children(node, own);
  }

  std::optional<std::array<double, 4>> view_box(const pugi::xml_node& node) {
    const pugi::xml_attribute attribute = node.attribute("viewBox");
    if (!attribute) return std::nullopt;
    const auto v = parse_numbers(attribute.value());
    if (v && v->size() == 4 && (*v)[2] >= 0 && (*v)[3] >= 0)
      return std::array<double, 4>{(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
    remark(node, "its viewBox is not four numbers with a size of at least 0, and is ignored");
    return std::nullopt;
  }

  void visit_use(const pugi::xml_node& node, Inherited own) {
    const pugi::xml_attribute plain = node.attribute("href");
    const std::string href = (plain ? plain : node.attribute("xlink:href")).value();
    const pugi::xml_node shown = href.starts_with('#') ? document_.find(href.substr(1)) : pugi::xml_node();
    const auto name = [&] { return printable(href.substr(0, 80)); };
    if (!shown) return remark(node, fmt::format("use of '{}', which is not in the document, is not drawn", name()));
    for (const pugi::xml_node& open : uses_)
      if (open == shown) return remark(node, fmt::format("use of '{}' inside itself is not drawn", name()));
    for (pugi::xml_node above = node.parent(); above; above = above.parent())
      if (above == shown) return remark(node, fmt::format("use of '{}' inside itself is not drawn", name()));
    if (uses_.size() >= kDeepestUse) return remark(node, "use is nested deeper than 32: it is not drawn");
    if (++use_count_ > kMostUses) document_.refuse(node, fmt::format("more than {} instances of `use`", kMostUses));
    const double x = length_of(node, "x", own.viewport.width, 0), y = length_of(node, "y", own.viewport.height, 0);
    if (!std::isfinite(x + y)) return remark(node, "its position is not understood: it is not drawn");
    own.to_px = own.to_px * Affine{1, 0, 0, 1, x, y};
    own.prefix = name_of(node, own) + "/";
    uses_.push_back(shown);
    if (local_name(shown) == "symbol")
      visit_symbol(shown, node, own);
    else
      visit(shown, own);
    uses_.pop_back();
  }

  void visit_symbol(const pugi::xml_node& symbol, const pugi::xml_node& use, Inherited own) {
    account(symbol);
    own.style = style_of(symbol, own);
    if (own.style.shown) visit_viewport(symbol, use, own);
  }

  std::string name_of(const pugi::xml_node& node, const Inherited& own) const {
    std::string name = own.prefix + document_.name_of(node);
    return name.size() <= kLongestName ? name : sha256(name);
  }

  void add_shape(std::string_view name, const pugi::xml_node& node, const Inherited& own) {
    const Style& style = own.style;
    Element element;
    const auto paint = [&](Paint p, double opacity) {
      if (opacity <= 0) return Paint::none;
      return p == Paint::current ? style.color : p;
    };
    element.fill = paint(style.fill, style.fill_opacity);
    element.stroke = style.stroke_width > 0 ? paint(style.stroke, style.stroke_opacity) : Paint::none;
    if (!style.visible || (element.fill == Paint::none && element.stroke == Paint::none)) return;
    Shape shape = shape_of(name, node, own.viewport, kMostCommands - commands_);
    commands_ += shape.commands;
    if (commands_ >= kMostCommands) document_.refuse(node, fmt::format("more than {} path commands", kMostCommands));
    if (!shape.problem.empty()) remark(node, fmt::format("{}: {}", name, shape.problem));
    if (shape.outline.empty()) return;
    element.outline = transformed(std::move(shape.outline), own.to_px);
    if (!(largest_coordinate(element.outline) <= kMostCoordinate))
      document_.refuse(node, fmt::format("{} has coordinates above {:g} pixels", name, kMostCoordinate));
    element.id = name_of(node, own);
    element.line = document_.line(node);
    element.rule = style.rule;
    element.stroke_width = style.stroke_width * (widths_as_written_ ? 1 : own.to_px.scale());
    out_.elements.push_back(std::move(element));
  }

  const Document& document_;
  bool widths_as_written_;
  StyleSheet sheet_;
  Elements out_;
  std::vector<pugi::xml_node> uses_;  // that are being shown
  std::set<std::pair<std::size_t, std::string>> said_;
  std::size_t unsaid_ = 0, visits_ = 0, bytes_ = 0, use_count_ = 0, commands_ = 0;
};

}  // namespace

Elements read_elements(const std::string& text, const std::string& file, bool widths_as_written) {
  const Document document(text, file);
  if (local_name(document.root()) != "svg")
    throw_invalid("{}:{}: the root element is '{}', expected 'svg'", file, document.line(document.root()),
                  printable(std::string(document.root().name()).substr(0, 80)));
  Elements all = Reader(document, widths_as_written).read();
  all.root_line = document.line(document.root());
  return all;
}

}  // namespace oxturn::svg
