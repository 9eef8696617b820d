#include "bench/metrics_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn {
namespace {

const char* const kHeader = "run_id,metric,value\n";

std::string lines_of(const std::string& run_id, const Records& records) {
  std::string lines;
  // Empty means not applicable; a figure that is not finite is empty.
  for (const auto& [name, value] : records)
    lines += fmt::format("{},{},{}\n", run_id, name, std::isfinite(value) ? to_decimal(value) : "");
  return lines;
}

}  // namespace

MetricsFile::MetricsFile(const std::string& folder) : file_(folder + "/metrics.csv") {
  if (!std::filesystem::exists(file_)) return;
  std::string text = read_file(file_);
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  std::string last;
  for (const auto& cells : parse_csv(text, file_)) {
    if (cells.size() != 3)
      throw std::invalid_argument(
          fmt::format("{}: a line has {} cells, expected run_id,metric,value", file_, cells.size()));
    if (cells[0] == "run_id") continue;
    double value = std::nan("");
    const std::string& number = cells[2];
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (!number.empty() && (error != std::errc() || end != number.data() + number.size()))
      throw std::invalid_argument(fmt::format("{}: '{}' is not a number", file_, number));
    Records& records = all_[cells[0]];
    // A later attempt follows other runs' lines, or its own with a name that was there.
    bool again = last != cells[0];
    for (const auto& [name, known] : records) again = again || name == cells[1];
    if (again) records.clear();
    last = cells[0];
    records.emplace_back(cells[1], value);
  }
}

void MetricsFile::append(const std::string& run_id, const Records& records) {
  all_[run_id] = records;
  if (records.empty()) return;
  const bool fresh = !std::filesystem::exists(file_);
  std::ofstream out(file_, std::ios::app | std::ios::binary);
  out << (fresh ? kHeader : "") << lines_of(run_id, records);
  out.flush();
  if (!out) throw std::runtime_error(fmt::format("cannot write '{}'", file_));
}

void MetricsFile::put_in_order(const std::vector<std::string>& run_ids) {
  std::string lines;
  for (const std::string& id : run_ids)
    if (const auto known = all_.find(id); known != all_.end()) lines += lines_of(id, known->second);
  if (!lines.empty() || std::filesystem::exists(file_)) write_file(file_, kHeader + lines);
}

}  // namespace oxturn
