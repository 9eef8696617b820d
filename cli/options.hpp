// Options that several commands share, and what they stand for.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/suite.hpp"
#include "geometry/path.hpp"
#include "maps/formats.hpp"
#include "base/parameters.hpp"
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
  std::string start, anchor;  // "X,Y" or a name (maps/places.hpp)
};
/// MAP itself is declared by the command, since its place among the arguments differs.
void add_problem_options(CLI::App& app, ProblemOptions& options);
/// Reads or makes the map; what was not given (robot, start) is chosen and said on standard error.
Problem load_problem(const ProblemOptions& options);

/// `--tethers N`, for pictures.
void add_tethers_drawn(CLI::App& app, int& count);
/// `--tether-trace FILE.csv`.
void add_tether_trace(CLI::App& app, std::string& file);
/// Throws if it is asked for and its file's name is wrong or cannot be written, or there is no tether to trace.
void check_tether_trace(const std::string& file);
void check_tether_trace(const std::string& file, const Robot& robot);
/// Writes it, if it was asked for.
void write_tether_trace(const std::string& file, const Problem& problem, const Path& path);

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
