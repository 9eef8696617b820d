/// What is running, and on what: for the identity of runs and for session.json. Internal to bench/.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace oxturn {

/// The first 16 hexadecimal digits of the SHA-256 of the file that this code was loaded from, program or library: equal
/// exactly for equal builds. Computed once; throws std::runtime_error if the file cannot be read.
const std::string& build_identity();

/// Version, revision, compiler, flags and versions of libraries.
nlohmann::ordered_json build_description();
/// Processor, cores, memory, kernel, frequency governor and load. What cannot be found out is missing.
nlohmann::ordered_json machine_description();

/// Processes ready to run, averaged over the last minute; negative if the system does not say.
double load_average();

}  // namespace oxturn
