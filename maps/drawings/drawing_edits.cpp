#include "maps/drawing_edits.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "geometry/overlay/cut_along.hpp"
#include "maps/formats/json.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr double kCutWidth = 1e-5;  // metres that a cut takes away; no tool leaves that uncovered
constexpr std::size_t kShownOfHash = 12;

/// A value of the edits and its JSON pointer.
struct Edit {
  JsonAt at;
  Edit(const Json& value, std::string where) : at{value, std::move(where)} {}

  [[noreturn]] void refuse(const std::string& what) const { throw_invalid("{}: {}", at.where, what); }
  /// Refuses keys other than these; the last ones may be missing.
  void require_keys(const std::vector<std::string>& needed, const std::vector<std::string>& optional = {}) const {
    if (!at.value.is_object()) at.refuse("an object");
    for (const auto& [key, value] : at.value.items())
      if (std::ranges::count(needed, key) + std::ranges::count(optional, key) == 0)
        throw_invalid("{}/{}: unknown key, expected one of: {}", at.where, key.substr(0, 80),
                      fmt::join(all_of(needed, optional), ", "));
    for (const std::string& key : needed)
      if (!at.value.contains(key)) throw_invalid("{}/{}: is missing", at.where, key);
  }
  bool has(const char* key) const { return at.value.contains(key); }
  Edit operator[](const char* key) const { return {at.value.at(key), at.where + "/" + key}; }
  Polyline points(std::size_t least) const {
    if (!at.value.is_array() || at.value.size() < least) at.refuse(fmt::format("a list of at least {} points", least));
    return at.points(at.where);
  }
  bool truth() const {
    if (!at.value.is_boolean()) at.refuse("true or false");
    return at.value.get<bool>();
  }
  template <class T>
  T choice(const std::vector<std::pair<std::string, T>>& known) const {
    for (const auto& [name, value] : known)
      if (at.value == name) return value;
    std::vector<std::string> names;
    for (const auto& [name, value] : known) names.push_back(name);
    at.refuse(fmt::format("one of: {}", fmt::join(names, ", ")));
  }

 private:
  static std::vector<std::string> all_of(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
};

class Editor {
 public:
  Editor(Drawing drawing, const Edit& root) : drawing_(std::move(drawing)), root_(root) {}

  Drawing run() {
    root_.require_keys({"oxturn_edits", "drawing_sha256"}, {"start", "cuts", "fills", "connections", "curves"});
    if (root_["oxturn_edits"].at.value != kVersion) root_["oxturn_edits"].at.refuse(fmt::format("{}", kVersion));
    const Edit hash = root_["drawing_sha256"];
    if (hash.at.text() != drawing_.sha256)
      hash.refuse(fmt::format("the edits are of another drawing ({}...), expected {}...",
                              printable_start(hash.at.text()), printable_start(drawing_.sha256)));
    if (root_.has("start")) drawing_.start = root_["start"].at.point();
    each("cuts", &Editor::cut);
    each("fills", &Editor::fill);
    each("connections", &Editor::connection);
    each("curves", &Editor::curve);
    return std::move(drawing_);
  }

 private:
  static std::string printable_start(const std::string& text) { return text.substr(0, kShownOfHash); }

  void each(const char* key, void (Editor::*apply)(const Edit&)) {
    if (!root_.has(key)) return;
    const Edit list = root_[key];
    if (!list.at.value.is_array()) list.at.refuse("a list");
    for (std::size_t i = 0; i < list.at.value.size(); ++i)
      (this->*apply)({list.at.value[i], fmt::format("{}/{}", list.at.where, i)});
  }

  void cut(const Edit& edit) {
    edit.require_keys({"element", "line"});
    const std::string element = element_with_area(edit["element"]);
    const Polyline line = edit["line"].points(2);
    std::vector<FilledArea> areas;
    bool any = false;
    for (FilledArea& area : drawing_.areas) {
      Region parts;
      if (area.element == element) parts = cut_along({{area.area}}, {line}, kCutWidth);
      if (parts.polygons.size() < 2) {
        areas.push_back(std::move(area));
        continue;
      }
      any = true;
      for (Polygon& part : parts.polygons) areas.push_back({element, std::move(part), area.choice});
    }
    drawing_.areas = std::move(areas);
    if (!any) edit["line"].refuse(fmt::format("does not cut an area of element '{}' in two", element));
  }

  void fill(const Edit& edit) {
    edit.require_keys({"element"}, {"at", "fill", "angle_deg", "outline"});
    const std::size_t index = area_of(edit);
    if (!filled_.insert(index).second) edit.refuse("the fill of this area was chosen already");
    FillChoice& choice = drawing_.areas[index].choice;
    if (edit.has("fill"))
      choice.fill = edit["fill"].choice<std::string>(
          {{"spiral", "spiral"}, {"zigzag", "zigzag"}, {"contour", "contour"}, {"none", "none"}});
    if (edit.has("angle_deg")) choice.angle = edit["angle_deg"].at.number("degrees") * kPi / 180;
    if (edit.has("outline")) choice.outline = edit["outline"].truth();
  }

  // How many connections a stroke or an area has room for is the planner's to judge.
  void connection(const Edit& edit) {
    edit.require_keys({"action", "from", "to"});
    const bool enforced = edit["action"].choice<bool>({{"enforce", true}, {"delete", false}});
    const DrawnConnection c{node(edit["from"]), node(edit["to"]), enforced};
    for (const DrawnConnection& other : drawing_.connections)
      if ((same(other.from, c.from) && same(other.to, c.to)) || (same(other.from, c.to) && same(other.to, c.from)))
        edit.refuse(other.enforced == c.enforced ? "this connection was given already"
                                                 : "the same connection is enforced and deleted");
    if (same(c.from, c.to)) edit.refuse("a connection from a node to itself");
    drawing_.connections.push_back(c);
  }
  void curve(const Edit& edit) {
    edit.require_keys({"from", "to", "kind", "points"});
    const auto kind = edit["kind"].choice<DrawnCurve::Kind>(
        {{"spiro", DrawnCurve::Kind::spiro}, {"bezier", DrawnCurve::Kind::bezier}});
    const DrawnCurve c{node(edit["from"]), node(edit["to"]), kind, edit["points"].points(1)};
    for (const DrawnCurve& other : drawing_.curves)
      if (same(other.from, c.from) && same(other.to, c.to))
        edit.refuse("the curve between these nodes was given already");
    drawing_.curves.push_back(c);
  }

  static bool same(const NodeOfElement& a, const NodeOfElement& b) {
    return a.element == b.element && a.node == b.node;
  }

  std::string element_with_area(const Edit& edit) const {
    const std::string name = edit.at.text();
    if (std::ranges::count(drawing_.areas, name, &FilledArea::element) == 0)
      edit.refuse(fmt::format("no filled element '{}'", name.substr(0, 80)));
    return name;
  }

  /// The area that an edit names: of an element in several parts by a point inside.
  std::size_t area_of(const Edit& edit) const {
    const std::string element = element_with_area(edit["element"]);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < drawing_.areas.size(); ++i)
      if (drawing_.areas[i].element == element &&
          (!edit.has("at") || contains(Region{{drawing_.areas[i].area}}, edit["at"].at.point())))
        found.push_back(i);
    if (found.size() == 1) return found.front();
    if (edit.has("at")) edit["at"].refuse(fmt::format("is not inside one area of element '{}'", element));
    edit.refuse(fmt::format("element '{}' has {} areas, expected `at` with a point inside one", element, found.size()));
  }

  NodeOfElement node(const Edit& edit) const {
    edit.require_keys({"element", "vertex"});
    const std::string name = edit["element"].at.text();
    const Edit vertex = edit["vertex"];
    if (!vertex.at.value.is_number_integer()) vertex.at.refuse("a whole number");
    std::size_t most = 0;
    for (const DrawnStroke& s : drawing_.strokes)
      if (s.element == name) most = std::max(most, s.nodes.size());
    for (const FilledArea& a : drawing_.areas)
      if (a.element == name) most = std::max(most, a.area.outer.size());
    if (most == 0) edit["element"].refuse(fmt::format("no element '{}'", name.substr(0, 80)));
    const auto last = static_cast<std::int64_t>(most) - 1, index = vertex.at.value.get<std::int64_t>();
    if (index > last || index < -1) vertex.at.refuse(fmt::format("0 to {}, or -1 for the last", last));
    return {name, static_cast<int>(index)};
  }

  Drawing drawing_;
  Edit root_;
  std::set<std::size_t> filled_;  // areas whose fill was chosen
};

}  // namespace

Drawing edited(Drawing drawing, const std::string& json, const std::string& source) {
  const Json root = parse_json(json, source);
  return Editor(std::move(drawing), {root, source + ": "}).run();
}

}  // namespace oxturn
