#include "maps/drawings/svg_values.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include "base/math.hpp"
#include "base/text.hpp"

namespace oxturn::svg {
namespace {

constexpr double kHuge = 1e300;  // above every limit on coordinates

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::size_t digits_from(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// The length of the number at the front of a text; 0: there is none.
std::size_t number_length(std::string_view text) {
  const std::size_t begin = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  std::size_t at = digits_from(text, begin), digits = at - begin;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = digits_from(text, at + 1);
    digits += end - at - 1;
    if (digits > 0) at = end;
  }
  if (digits == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-') ? 1 : 0;
    if (const std::size_t end = digits_from(text, at + 1 + sign); end > at + 1 + sign) at = end;
  }
  return at;
}

/// The numbers in the brackets of "name(1, 2)", whose name was read.
std::optional<std::vector<double>> arguments(Scanner& scan) {
  constexpr std::size_t kMost = 6;
  scan.skip_blanks();
  if (!scan.take('(')) return std::nullopt;
  std::vector<double> values;
  for (scan.skip_blanks(); !scan.take(')'); scan.skip_separator()) {
    const auto value = scan.number();
    if (!value || values.size() == kMost) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<Affine> primitive(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Affine{1, 0, 0, 1, v[0], n > 1 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, n > 1 ? v[1] : v[0], 0, 0};
  if (name == "skewX" && n == 1) return Affine{1, 0, math::tan(v[0] * kPi / 180), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine{1, math::tan(v[0] * kPi / 180), 0, 1, 0, 0};
  if (name == "rotate" && (n == 1 || n == 3)) {
    const double c = math::cos(v[0] * kPi / 180), s = math::sin(v[0] * kPi / 180);
    const Affine turn{c, s, -s, c, 0, 0};
    if (n == 1) return turn;
    return Affine{1, 0, 0, 1, v[1], v[2]} * turn * Affine{1, 0, 0, 1, -v[1], -v[2]};
  }
  return std::nullopt;
}

Paint paint_of(int red, int green, int blue) {
  if (red == 255 && green == 255 && blue == 255) return Paint::white;
  if (red == 255 && green == 0 && blue == 0) return Paint::red;
  if (red == 0 && green == 255 && blue == 0) return Paint::green;
  return Paint::other;
}

std::optional<Paint> hexadecimal_paint(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  const auto byte = [&](unsigned shift) { return static_cast<int>(value >> shift & 255u); };
  const auto nibble = [&](unsigned shift) { return static_cast<int>((value >> shift & 15u) * 17u); };
  switch (digits.size()) {
    case 3:
      return paint_of(nibble(8), nibble(4), nibble(0));
    case 4:
      return nibble(0) == 0 ? Paint::none : paint_of(nibble(12), nibble(8), nibble(4));
    case 6:
      return paint_of(byte(16), byte(8), byte(0));
    case 8:
      return byte(0) == 0 ? Paint::none : paint_of(byte(24), byte(16), byte(8));
    default:
      return std::nullopt;
  }
}

/// "rgb(255, 0, 0)", "rgb(100% 0% 0%)", with or without alpha.
std::optional<Paint> function_paint(std::string_view text) {
  Scanner scan(text);
  const std::string name = lower_case(scan.word());
  if (name == "hsl" || name == "hsla") return Paint::other;
  if ((name != "rgb" && name != "rgba") || !scan.take('(')) return std::nullopt;
  std::array<double, 4> v{0, 0, 0, 1};
  std::size_t n = 0;
  for (scan.skip_blanks(); !scan.take(')'); ++n) {
    const auto value = scan.number();
    if (!value || n == v.size()) return std::nullopt;
    v[n] = scan.take('%') ? *value * (n < 3 ? 2.55 : 0.01) : *value;
    scan.skip_separator();
    if (scan.take('/')) scan.skip_blanks();
  }
  if (n < 3) return std::nullopt;
  if (v[3] <= 0) return Paint::none;
  const auto byte = [&](std::size_t i) { return static_cast<int>(std::lround(std::clamp(v[i], 0.0, 255.0))); };
  return paint_of(byte(0), byte(1), byte(2));
}

}  // namespace

void Scanner::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}
void Scanner::skip_separator() {
  skip_blanks();
  if (take(',')) skip_blanks();
}
bool Scanner::done() {
  skip_blanks();
  return rest_.empty();
}
char Scanner::take() {
  const char c = rest_.front();
  rest_.remove_prefix(1);
  return c;
}
bool Scanner::take(char c) {
  if (peek() != c || rest_.empty()) return false;
  rest_.remove_prefix(1);
  return true;
}
std::optional<double> Scanner::number() {
  const std::size_t size = number_length(rest_);
  if (size == 0) return std::nullopt;
  std::string_view token = rest_.substr(0, size);
  rest_.remove_prefix(size);
  if (token.front() == '+') token.remove_prefix(1);
  double value = 0;
  if (std::from_chars(token.data(), token.data() + token.size(), value).ec == std::errc::result_out_of_range)
    return token.find("e-") != token.npos || token.find("E-") != token.npos ? 0 : token.front() == '-' ? -kHuge : kHuge;
  return value;
}
std::optional<bool> Scanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  return take() == '1';
}
std::string_view Scanner::word() {
  std::size_t n = 0;
  while (n < rest_.size() && (is_letter(rest_[n]) || is_digit(rest_[n]) || rest_[n] == '-' || rest_[n] == '_')) ++n;
  const std::string_view found = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return found;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> parse_length(std::string_view text, double whole) {
  static const std::map<std::string_view, double> kUnits{{"", 1},    {"px", 1},         {"pt", 4.0 / 3},   {"pc", 16},
                                                         {"in", 96}, {"cm", 96 / 2.54}, {"mm", 9.6 / 2.54}};
  Scanner scan(trimmed(text));
  const auto value = scan.number();
  if (!value) return std::nullopt;
  if (scan.rest() == "%") return *value / 100 * whole;
  const auto unit = kUnits.find(scan.rest());
  if (unit == kUnits.end()) return std::nullopt;
  return *value * unit->second;
}

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  Scanner scan(text);
  std::vector<double> values;
  for (scan.skip_blanks(); !scan.done(); scan.skip_separator()) {
    const auto value = scan.number();
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<Affine> parse_transform(std::string_view text) {
  Scanner scan(text);
  Affine all;
  if (trimmed(text) == "none") return all;
  for (scan.skip_blanks(); !scan.done(); scan.skip_separator()) {
    const std::string_view name = scan.word();
    const auto values = arguments(scan);
    const auto next = values ? primitive(name, *values) : std::nullopt;
    if (!next) return std::nullopt;
    all = all * *next;
  }
  return all;
}

std::optional<Paint> parse_paint(std::string_view text, bool& server) {
  static const std::map<std::string, Paint> kNames{{"none", Paint::none},   {"transparent", Paint::none},
                                                   {"white", Paint::white}, {"red", Paint::red},
                                                   {"lime", Paint::green},  {"currentcolor", Paint::current}};
  text = trimmed(text);
  if (text.empty()) return std::nullopt;
  if (text.starts_with("url(")) {
    server = true;
    return Paint::other;
  }
  if (text.front() == '#') return hexadecimal_paint(text.substr(1));
  if (text.find('(') != text.npos) return function_paint(text);
  if (const auto named = kNames.find(lower_case(text)); named != kNames.end()) return named->second;
  // Any other name of a colour. That it is one of CSS's 148 names does not matter to the robot.
  if (text == "inherit" || text == "initial" || !std::ranges::all_of(text, is_letter)) return std::nullopt;
  return Paint::other;
}

}  // namespace oxturn::svg
