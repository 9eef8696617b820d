/// Text and numbers for reports: escaping, rounding, medians.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/results.hpp"

namespace oxturn {

/// For a cell of a Markdown table: pipes, line breaks, angle brackets and emphasis are escaped.
std::string escape_markdown(const std::string& text);
/// For a relative link: everything but letters, digits and -._~/ as %XX.
std::string escape_url(const std::string& text);

/// The middle value, or the mean of the two in the middle; empty for none.
std::optional<double> median(std::vector<double> values);
/// `digits` decimals; "" for an empty value.
std::string fixed(std::optional<double> value, int digits);

/// With two significant digits, never as a power of ten: "0.0031", "1300"; "" for an empty value.
std::string two_digits(std::optional<double> value);

/// A value of `column` for every row that has one.
std::vector<double> numbers(const std::vector<const Row*>& rows, const std::string& column);
/// The run gave a valid path: `ok` or `partial`.
bool valid_path(const Row& row);

/// A time in seconds with about three significant digits.
std::string seconds(std::optional<double> value);

/// A Markdown table; cells are already escaped. `align` has a letter for each column: 'l' or 'r'.
std::string markdown_table(const std::string& align, const std::vector<std::string>& head,
                           const std::vector<std::vector<std::string>>& rows);

}  // namespace oxturn
