// Options that several commands share, and what they stand for.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite.hpp"
#include "maps/formats.hpp"
#include "maps/parameters.hpp"
#include "maps/problem.hpp"

namespace oxturn::cli {

// --- settings ----------------------------------------------------------------------------------------------
/// `--set k=v`, repeated.
void add_settings(CLI::App& app, std::vector<std::string>& assignments, const std::string& of_what);
/// Checked against the parameters of `owner` ("planner 'stc'").
Settings parse_settings(const std::string& owner, const std::vector<ParameterInfo>& parameters,
                        const std::vector<std::string>& assignments);

// --- maps --------------------------------------------------------------------------------------------------
/// --scale, --unknown-free, --drop-speckle, --simplify.
void add_reader_options(CLI::App& app, ReadOptions& options);
/// Prints each of the reader's remarks on standard error.
void say_remarks(const MapFile& file);
bool file_exists(const std::string& name);

// --- problems ----------------------------------------------------------------------------------------------
struct ProblemOptions {
  std::string map;  // a file, or GENERATOR[:SEED]
  ReadOptions read;
  std::string robot;  // "radius=0.2,speed=1"
  std::optional<double> radius, tool_width;
  std::string start;  // "X,Y"
};
/// MAP itself is declared by the command, since its place among the arguments differs.
void add_problem_options(CLI::App& app, ProblemOptions& options);
/// Reads or makes the map; what was not given (robot, start) is chosen and said on standard error.
Problem load_problem(const ProblemOptions& options);

// --- output ------------------------------------------------------------------------------------------------
/// Throws "cannot write ..." now rather than after the work. Nothing is left behind.
void require_writable(const std::string& file);
/// Throws unless the file's name ends in one of `suffixes`.
void require_suffix(const std::string& file, const std::vector<std::string>& suffixes);
bool has_suffix(const std::string& file, const std::string& suffix);
/// A line on standard error: "oxturn: ...".
void say(const std::string& sentence);

/// A validator for options that are numbers: finite, and at least (or above) `least`.
CLI::Validator number_from(double least, bool included, const std::string& unit);
/// For seeds: digits only. (A minus sign would be read as a number near 2^64.)
CLI::Validator whole_number();

}  // namespace oxturn::cli
