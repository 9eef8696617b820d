#include "bench/build_info.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <Eigen/Core>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "base/sha256.hpp"
#include "build_revision.hpp"

namespace oxturn {
namespace {

std::string first_line(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

/// The value of the first line "KEY : VALUE" of a file in /proc; "" if there is none.
std::string proc_value(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t colon = line.find(':');
    const std::size_t begin = colon == std::string::npos ? colon : line.find_first_not_of(" \t", colon + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

std::string loaded_file() {
  Dl_info info{};
  if (::dladdr(reinterpret_cast<const void*>(&build_identity), &info) == 0 || info.dli_fname == nullptr)
    return "/proc/self/exe";
  // The name of a program is what it was called by; its file may be elsewhere on the PATH.
  return std::string(info.dli_fname).find(".so") != std::string::npos ? info.dli_fname : "/proc/self/exe";
}

}  // namespace

const std::string& build_identity() {
  static const std::string identity = [] {
    std::ifstream in(loaded_file(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in || bytes.empty()) throw std::runtime_error("cannot read the program's own file");
    return sha256(bytes).substr(0, 16);
  }();
  return identity;
}

nlohmann::ordered_json build_description() {
  return {{"identity", build_identity()},
          {"version", OXTURN_VERSION},
          {"revision", kRevision},
          {"compiler", __VERSION__},
          {"flags", OXTURN_FLAGS},
#ifdef NDEBUG
          {"asserts", false},
#else
          {"asserts", true},
#endif
          {"libraries",
           {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
            {"cgal", OXTURN_CGAL_VERSION},
            {"glibcxx", __GLIBCXX__}}}};
}

nlohmann::ordered_json machine_description() {
  nlohmann::ordered_json json;
  char host[256] = {};
  if (::gethostname(host, sizeof host - 1) == 0) json["host"] = host;
  utsname system{};
  if (::uname(&system) == 0) json["kernel"] = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
  const auto add = [&](const char* key, const std::string& value) {
    if (!value.empty()) json[key] = value;
  };
  add("cpu", proc_value("/proc/cpuinfo", "model name"));
  json["cores"] = std::thread::hardware_concurrency();
  add("memory", proc_value("/proc/meminfo", "MemTotal"));
  add("governor", first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor"));
  if (const double load = load_average(); load >= 0) json["load"] = load;
  return json;
}

double load_average() {
  double load = -1;
  return ::getloadavg(&load, 1) == 1 ? load : -1;
}

}  // namespace oxturn
