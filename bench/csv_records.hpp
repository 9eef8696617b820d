/// The records of a CSV file one at a time, for files that are larger than memory should hold. Internal to bench/.
///
///   for_each_record("out/runs.csv", [](const std::string& record) { parse_csv(record, "out/runs.csv"); });
#pragma once

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

namespace oxturn {

/// f(record) with its line break. Line breaks within quotes belong to the record; an incomplete last one is dropped.
/// Throws std::invalid_argument if there is no such file.
template <class F>
void for_each_record(const std::string& file, F f) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::invalid_argument("cannot read '" + file + "'; expected a folder that `oxturn run -o` made");
  std::string record;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    record += line + '\n';
    if (std::count(record.begin(), record.end(), '"') % 2 != 0) continue;
    f(record);
    record.clear();
  }
}

}  // namespace oxturn
