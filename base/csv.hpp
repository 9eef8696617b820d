/// Comma-separated values, after RFC 4180.
///
///   csv_line({"a", "b,c"})                   // "a,\"b,c\"\n"
///   parse_csv(read_file(name), name)[0]      // cells of the first line
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace oxturn {

/// One line with cells quoted where necessary. It ends in \n, not in the RFC's \r\n, which readers accept as well.
std::string csv_line(const std::vector<std::string>& cells);

/// The cells of each line. Quoted cells may contain commas, line breaks and doubled quotes; lines may end in \r\n.
/// Throws std::invalid_argument "SOURCE:LINE: what is wrong".
std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& source);
/// The same for one line after another, for tables that are too large to be held cell by cell.
void for_each_csv_line(const std::string& text, const std::string& source,
                       const std::function<void(std::vector<std::string>)>& f);

}  // namespace oxturn
