#include "bench/run_lines.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/csv.hpp"
#include "base/files.hpp"

namespace oxturn {
namespace {

std::string text_of(const std::string& run_id, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += fmt::format("{},{}\n", run_id, line);
  return text;
}

}  // namespace

RunLines::RunLines(const std::string& folder, const std::string& name, std::string header, bool keep)
    : file_(folder + "/" + name), header_(std::move(header)), keep_(keep) {
  if (!keep_ || !std::filesystem::exists(file_)) return;
  std::string text = read_file(file_);
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  const std::size_t wanted = parse_csv(header_, file_).front().size();
  std::string last, first_key;  // of the lines of one attempt
  for (const auto& cells : parse_csv(text, file_)) {
    if (cells.size() != wanted)
      throw std::invalid_argument(fmt::format("{}: a line has {} cells, expected {}; remove the file to start it anew",
                                              file_, cells.size(), header_.substr(0, header_.size() - 1)));
    if (cells[0] == "run_id") continue;
    std::vector<std::string>& lines = all_[cells[0]];
    if (cells[0] != last || cells[1] == first_key) {  // another attempt
      lines.clear();
      first_key = cells[1];
    }
    last = cells[0];
    const std::string line = csv_line({cells.begin() + 1, cells.end()});
    lines.push_back(line.substr(0, line.size() - 1));
  }
}

void RunLines::append(const std::string& run_id, const std::vector<std::string>& lines) {
  set(run_id, lines);
  if (lines.empty()) return;
  const bool fresh = !std::filesystem::exists(file_);
  std::ofstream out(file_, std::ios::app | std::ios::binary);
  out << (fresh ? header_ : "") << text_of(run_id, lines);
  out.flush();
  if (!out) throw std::runtime_error(fmt::format("cannot write '{}'", file_));
}

void RunLines::put_in_order(const std::vector<std::string>& run_ids) {
  std::string text;
  for (const std::string& id : run_ids)
    if (const auto known = all_.find(id); known != all_.end()) text += text_of(id, known->second);
  if (!text.empty() || std::filesystem::exists(file_)) write_file(file_, header_ + text);
}

}  // namespace oxturn
