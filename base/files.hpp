/// Reading and writing whole files.
///
///   const std::string yaml = read_file("kitchen.yaml");
///   write_file("out/plan.svg", picture);
///   write_file(kStandardStream, picture);                   // "-": standard output
#pragma once

#include <string>

namespace oxturn {

/// As a file's name: standard input where a file is read, standard output where one is written.
inline constexpr const char* kStandardStream = "-";

/// The content of a regular file, or of standard input, of at most 4 GiB. Throws std::invalid_argument
/// "no such file: 'x'", or with the reason why it cannot be read.
std::string read_file(const std::string& file);

/// Writes a temporary file in the same folder and renames it, so that a reader never sees half a file. Devices, pipes
/// and standard output are written directly. Throws std::runtime_error "cannot write 'out/x.svg': Permission denied".
void write_file(const std::string& file, const std::string& content);

}  // namespace oxturn
