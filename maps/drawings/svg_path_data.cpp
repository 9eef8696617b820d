// The path data of SVG 1.1, section 8.3: all commands, absolute and relative, repeated without their letter, with
// numbers and flags packed as tightly as the grammar allows. Of data with an error, what comes before it is drawn.
#include <cctype>

#include "maps/drawings/svg_values.hpp"

namespace oxturn::svg {
namespace {

class PathParser {
 public:
  PathParser(std::string_view text, std::size_t most) : scan_(text), most_(most) {}

  ParsedPath parse() {
    char letter = 0;
    for (scan_.skip_blanks(); !scan_.done(); scan_.skip_separator()) {
      if (std::isalpha(static_cast<unsigned char>(scan_.peek())) != 0)
        letter = scan_.take();
      else if (letter == 'M' || letter == 'm')
        letter = letter == 'M' ? 'L' : 'l';  // further points of a move are lines
      else if (letter == 0 || letter == 'Z' || letter == 'z')
        return broken();
      if (data_.commands == 0 && letter != 'M' && letter != 'm') return broken();
      if (data_.commands >= most_ || !command(letter)) return broken();
      ++data_.commands;
    }
    finish();
    return std::move(data_);
  }

 private:
  ParsedPath broken() {
    data_.broken = true;
    finish();
    return std::move(data_);
  }

  bool command(char letter) {
    relative_ = letter >= 'a';
    switch (std::toupper(static_cast<unsigned char>(letter))) {
      case 'M':
        return move();
      case 'Z':
        return close();
      case 'L':
        return read(1) && add(line(at_, p_[0]), at_);
      case 'H':
        return horizontal();
      case 'V':
        return vertical();
      case 'C':
        return read(3) && add(cubic(at_, p_[0], p_[1], p_[2]), p_[1]);
      case 'S':
        return read(2) && add(cubic(at_, reflected('C'), p_[0], p_[1]), p_[0], 'C');
      case 'Q':
        return read(2) && add(quadratic(at_, p_[0], p_[1]), p_[0], 'Q');
      case 'T':
        return read(1) && smooth_quadratic();
      case 'A':
        return elliptical_arc();
      default:
        return false;
    }
  }

  /// Reads n points into p_.
  bool read(std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto x = value(), y = x ? value() : std::nullopt;
      if (!y) return false;
      p_[i] = Point(*x, *y) + (relative_ ? at_ : Point(0, 0));
    }
    return true;
  }
  std::optional<double> value() {
    scan_.skip_separator();
    return scan_.number();
  }

  bool move() {
    if (!read(1)) return false;
    finish();
    at_ = start_ = p_[0];
    family_ = 0;
    return true;
  }
  bool close() {
    if (!path_.segments.empty()) {
      if (at_ != start_) path_.segments.push_back(line(at_, start_));
      path_.closed = true;
      finish();
    }
    at_ = start_;
    family_ = 0;
    return true;
  }
  bool horizontal() {
    const auto x = value();
    return x && add(line(at_, {*x + (relative_ ? at_.x() : 0), at_.y()}), at_);
  }
  bool vertical() {
    const auto y = value();
    return y && add(line(at_, {at_.x(), *y + (relative_ ? at_.y() : 0)}), at_);
  }
  bool smooth_quadratic() {
    const Point control = reflected('Q');
    return add(quadratic(at_, control, p_[0]), control, 'Q');
  }
  bool elliptical_arc() {
    const auto rx = value(), ry = rx ? value() : std::nullopt, turn = ry ? value() : std::nullopt;
    if (!turn) return false;
    scan_.skip_separator();
    const auto large = scan_.flag();
    scan_.skip_separator();
    const auto positive = large ? scan_.flag() : std::nullopt;
    if (!positive || !read(1)) return false;
    return p_[0] == at_ || add(arc_between(at_, p_[0], {*rx, *ry}, *turn * kPi / 180, *large, *positive), at_);
  }

  /// The control point of a smooth curve: the last one reflected, if the last command was of the same family.
  Point reflected(char family) const { return family_ == family ? Point(2 * at_ - control_) : at_; }
  bool add(const CurveSegment& segment, const Point& control) {
    return add(segment, control, segment.kind == kCubic ? 'C' : 0);
  }
  bool add(const CurveSegment& segment, const Point& control, char family) {
    path_.segments.push_back(segment);
    control_ = control;
    family_ = family;
    at_ = segment.kind == CurveSegment::Kind::arc ? p_[0] : segment.end();
    return true;
  }
  void finish() {
    if (path_.segments.empty()) return;
    if (at_ == start_) path_.closed = true;
    data_.outline.push_back(std::move(path_));
    path_ = {};
  }

  static constexpr auto kCubic = CurveSegment::Kind::cubic;
  Scanner scan_;
  std::size_t most_;
  ParsedPath data_;
  Subpath path_;
  Point at_{0, 0}, start_{0, 0}, control_{0, 0};
  std::array<Point, 3> p_{};
  char family_ = 0;  // of the last command: C, Q or neither
  bool relative_ = false;
};

}  // namespace

ParsedPath parse_path(std::string_view text, std::size_t most) { return PathParser(text, most).parse(); }

}  // namespace oxturn::svg
