#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace oxturn {

std::string escape_markdown(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\r')
      out += ' ';
    else if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else {
      if (c == '|' || c == '*' || c == '`' || c == '[' || c == ']' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out;
}

std::string escape_url(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                       c == '.' || c == '_' || c == '~' || c == '/';
    if (plain)
      out += c;
    else
      out += fmt::format("%{:02X}", u);
  }
  return out;
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::string fixed(std::optional<double> value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "";
}

std::vector<double> numbers(const std::vector<const Row*>& rows, const std::string& column) {
  std::vector<double> out;
  for (const Row* row : rows)
    if (const auto v = row->number(column)) out.push_back(*v);
  return out;
}

bool valid_path(const Row& row) {
  const Outcome outcome = row.outcome();
  return outcome == Outcome::ok || outcome == Outcome::partial;
}

std::string two_digits(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "";
  if (*value == 0) return "0";
  const double unit = std::pow(10, std::floor(std::log10(std::abs(*value))) - 1);
  const double rounded = std::round(*value / unit) * unit;
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(std::abs(rounded) * (1 + 1e-12)))));
  return fmt::format("{:.{}f}", rounded, decimals);
}

std::string seconds(std::optional<double> value) {
  return fixed(value, !value || *value >= 10 ? 1 : *value >= 0.1 ? 3 : 4);
}

std::string markdown_table(const std::string& align, const std::vector<std::string>& head,
                           const std::vector<std::vector<std::string>>& rows) {
  // Padded, so that the file reads well as plain text too.
  std::vector<std::size_t> width;
  width.reserve(head.size());
  for (const std::string& h : head) width.push_back(std::max<std::size_t>(h.size(), 3));
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  std::string out;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string space(width[i] - cells[i].size(), ' ');
      out += align[i] == 'l' ? "| " + cells[i] + space + " " : "| " + space + cells[i] + " ";
    }
    out += "|\n";
  };
  line(head);
  for (std::size_t i = 0; i < head.size(); ++i)
    out += align[i] == 'l' ? "| " + std::string(width[i], '-') + " " : "| " + std::string(width[i] - 1, '-') + ": ";
  out += "|\n";
  for (const auto& row : rows) line(row);
  return out;
}

}  // namespace oxturn
