#include "base/csv.hpp"

#include "base/throw_invalid.hpp"

namespace oxturn {

namespace {

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string out = "\"";
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "," : "") + quoted(cells[i]);
  return line + '\n';
}

std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& source) {
  std::vector<std::vector<std::string>> lines;
  for_each_csv_line(text, source, [&](std::vector<std::string> cells) { lines.push_back(std::move(cells)); });
  return lines;
}

void for_each_csv_line(const std::string& text, const std::string& source,
                       const std::function<void(std::vector<std::string>)>& f) {
  std::vector<std::string> cells;
  std::string cell;
  std::size_t line = 1, opened = 0;
  bool in_quotes = false, was_quoted = false;
  const auto end_cell = [&] {
    cells.push_back(std::move(cell));
    cell.clear();
    was_quoted = false;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_quotes) {
      if (c == '\n') ++line;
      if (c != '"') {
        cell += c;
      } else if (i + 1 < text.size() && text[i + 1] == '"') {
        cell += '"';
        ++i;
      } else {
        in_quotes = false;
      }
    } else if (c == '"') {
      if (!cell.empty() || was_quoted) {
        throw_invalid(
            "{}:{}: a quote in the middle of a cell; quote the whole cell and "
            "double the quotes inside",
            source, line);
      }
      in_quotes = was_quoted = true;
      opened = line;
    } else if (c == ',') {
      end_cell();
    } else if (c == '\n' || (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n')) {
      if (c == '\r') ++i;
      ++line;
      end_cell();
      f(std::move(cells));
      cells.clear();
    } else if (was_quoted) {
      throw_invalid("{}:{}: text after a closing quote; expected a comma or the line's end", source, line);
    } else {
      cell += c;
    }
  }
  if (in_quotes) throw_invalid("{}:{}: a quote is never closed", source, opened);
  if (!cell.empty() || was_quoted || !cells.empty()) {
    end_cell();
    f(std::move(cells));
  }
}

}  // namespace oxturn
