// Paths as CSV: x,y[,tool[,reverse[,width]]], a point a line.
//
// Decisions   1. A first line whose first cell is no number is a header: it names the columns, in any order, and those
//                with other names are ignored.
//             2. `tool`, `reverse` and `width` hold from their point to the next, so a change begins a leg at the
//                point where it stands.
//             3. Empty lines and lines that begin with # are skipped; lines may end in \r\n, and the file may begin
//                with a byte order mark.
#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostShown = 40;     // bytes of a cell in messages
constexpr std::size_t kMostColumns = 100;  // more is no path

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The cells of a line, without blanks and quotes round them. No cell of a path contains a comma.
void split_cells(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (comma == std::string_view::npos || cells.size() > kMostColumns) return;
    line.remove_prefix(comma + 1);
  }
}

class CsvReader {
 public:
  explicit CsvReader(const std::string& source) : source_(source) {}

  Path read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      ++line_;
      if (const std::string_view line = trimmed(text.substr(0, end)); !line.empty() && line.front() != '#') take(line);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (points_ < 2) throw_invalid("{} has {} point{}, expected at least 2", source_, points_, points_ == 1 ? "" : "s");
    if (path_.legs.back().points.size() < 2) path_.legs.pop_back();  // the tool changed at the last point
    return std::move(path_);
  }

 private:
  void take(std::string_view line) {
    split_cells(line, cells_);
    if (columns_ == 0)
      if (begin()) return;
    if (cells_.size() != columns_)
      throw_invalid("{}:{}: {} column{}, expected {}", source_, line_, cells_.size(), cells_.size() == 1 ? "" : "s",
                    columns_);
    const bool tool = tool_ == kNone || truth(tool_, "tool");
    const bool reverse = reverse_ != kNone && truth(reverse_, "reverse");
    const double width = width_ == kNone ? 0 : number(width_, "width");
    if (width < 0) refuse(width_, "width", "metres from 0");
    add({number(x_, "x"), number(y_, "y")}, tool, reverse ? Gear::reverse : Gear::forward, width);
  }

  /// Learns the columns from the first line; true if that is a header.
  bool begin() {
    columns_ = cells_.size();
    if (parse_all<double>(cells_[0])) {
      if (columns_ < 2 || columns_ > 5)
        throw_invalid("{}:{}: {} column{}, expected x,y[,tool[,reverse[,width]]]", source_, line_, columns_,
                      columns_ == 1 ? "" : "s");
      x_ = 0, y_ = 1, tool_ = columns_ > 2 ? 2 : kNone, reverse_ = columns_ > 3 ? 3 : kNone;
      width_ = columns_ > 4 ? 4 : kNone;
      return false;
    }
    const auto column = [&](const char* name) {
      const auto found = std::ranges::find_if(cells_, [&](std::string_view cell) { return lower_case(cell) == name; });
      return found == cells_.end() ? kNone : static_cast<std::size_t>(found - cells_.begin());
    };
    x_ = column("x"), y_ = column("y"), tool_ = column("tool"), reverse_ = column("reverse");
    width_ = column("width");
    if (x_ == kNone || y_ == kNone)
      throw_invalid(
          "{}:{}: begins with '{}', expected numbers x,y[,tool[,reverse[,width]]] or a header with the columns x and y",
          source_, line_, shown(cells_[0]));
    return true;
  }

  /// A point of the path, and the tool, gear and width from there on.
  void add(const Point& point, bool tool, Gear gear, double width) {
    if (points_ > 0) path_.legs.back().points.push_back(point);
    if (points_ == 0 || path_.legs.back().tool != tool || path_.legs.back().gear != gear ||
        path_.legs.back().width != width)
      path_.legs.push_back({tool, {point}, gear, width});
    ++points_;
  }

  double number(std::size_t column, const char* name) const {
    if (const auto value = parse_number(cells_[column])) return *value;
    refuse(column, name, "a finite number in metres");
  }
  bool truth(std::size_t column, const char* name) const {
    const std::string text = lower_case(cells_[column]);
    if (text == "1" || text == "on" || text == "true") return true;
    if (text == "0" || text == "off" || text == "false") return false;
    refuse(column, name, "1 or 0, on or off, true or false");
  }
  [[noreturn]] void refuse(std::size_t column, const char* name, const char* expected) const {
    throw_invalid("{}:{}: column {} ({}) is '{}', expected {}", source_, line_, column + 1, name, shown(cells_[column]),
                  expected);
  }
  static std::string shown(std::string_view cell) {
    return printable(cell.substr(0, kMostShown)) + (cell.size() > kMostShown ? "..." : "");
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const std::string& source_;
  Path path_;
  std::vector<std::string_view> cells_;
  std::size_t line_ = 0, points_ = 0, columns_ = 0, x_ = 0, y_ = 0, tool_ = 0, reverse_ = 0, width_ = 0;
};

}  // namespace

Path path_from_csv(const std::string& text, const std::string& source) { return CsvReader(source).read(text); }

}  // namespace oxturn
