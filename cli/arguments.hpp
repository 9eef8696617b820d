/// Arguments that several commands share: settings, output files, validators.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/parameters.hpp"

namespace oxturn::cli {

// --- settings ----------------------------------------------------------------------------------------------
/// `--set k=v`, repeated.
void add_settings(CLI::App& app, std::vector<std::string>& assignments, const std::string& of_what,
                  const std::string& list);
/// Checked against the parameters of `owner` ("planner 'stc'"). `given_by` is where they stand.
Settings parse_settings(const std::string& owner, const std::vector<ParameterInfo>& parameters,
                        const std::vector<std::string>& assignments, const std::string& given_by = "--set");
/// "name=value" in two; throws "OPTION 'TEXT': expected name=value".
std::pair<std::string, std::string> assignment(const std::string& option, const std::string& text);
std::vector<std::string> split(const std::string& text, char at);

// --- files -------------------------------------------------------------------------------------------------
bool file_exists(const std::string& name);
/// "-": standard input where a file is read, standard output where one is written. All that a command prints goes to
/// standard error then, so that a pipe carries the file alone.
bool is_standard_stream(const std::string& file);
struct NamedFile {
  std::string option, file;
};
/// Throws if more than one of the files is standard input, or standard output.
void require_one_stream(const std::vector<NamedFile>& files, const std::string& stream);
/// Where a command prints that writes these files: standard output, or standard error if one of them is.
std::FILE* print_to(const std::vector<std::string>& files);
/// Throws "cannot write ..." now rather than after the work. Nothing is left behind.
void require_writable(const std::string& file);
/// Throws unless the file's name ends in one of `suffixes`, or is standard output.
void require_suffix(const std::string& file, const std::vector<std::string>& suffixes);

/// A line on standard error: "oxturn: ...".
void say(const std::string& sentence);

// --- validators --------------------------------------------------------------------------------------------
/// For options that are numbers: finite, and at least (or above) `least`.
CLI::Validator number_from(double least, bool included, const std::string& unit);
/// For seeds: digits only. (A minus sign would be read as a number near 2^64.)
CLI::Validator whole_number();

}  // namespace oxturn::cli
