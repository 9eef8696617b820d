/// Whole files, read and written.
///
///   const std::string yaml = read_file("kitchen.yaml");
///   write_file("out/plan.svg", picture);
#pragma once

#include <string>

namespace oxturn {

/// The whole content of a regular file of at most 4 GiB. Throws std::invalid_argument "no such file: 'x'" or why it cannot
/// be read.
std::string read_file(const std::string& file);

/// Writes to a temporary file beside the target and renames it, so that nothing half-written is ever left; devices and
/// pipes are written directly. Throws std::runtime_error "cannot write 'out/x.svg': Permission denied".
void write_file(const std::string& file, const std::string& content);

}  // namespace oxturn
