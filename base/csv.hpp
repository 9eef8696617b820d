/// Comma-separated values as RFC 4180 describes them.
///
///   csv_line({"a", "b,c"})                   // "a,\"b,c\"\n"
///   parse_csv(read_file(name), name)[0]      // cells of the first line
#pragma once

#include <string>
#include <vector>

namespace oxturn {

/// One line, ended by \n alone, which readers of the RFC accept too.
std::string csv_line(const std::vector<std::string>& cells);

/// Quotes, commas and line breaks in quotes; lines may end in \r\n. Throws std::invalid_argument "SOURCE:LINE: what is
/// wrong".
std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& source);

}  // namespace oxturn
