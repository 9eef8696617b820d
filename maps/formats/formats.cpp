// The one list of map formats.

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/files.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {

MapFormat ros_format();
MapFormat geojson_format();
MapFormat image_format();
MapFormat svg_format();
MapFormat polygon_format();

MapFormats built_in_map_formats() {
  return MapFormats("map format", {ros_format(), geojson_format(), image_format(), svg_format(), polygon_format()});
}

std::string suffix_of(const std::string& file) { return lower_case(std::filesystem::path(file).extension().string()); }

namespace {

constexpr const char* kStreamFormat = "geojson";

/// What a format is wanted for.
struct Use {
  const char* verb;
  bool (*possible)(const MapFormat& format);
};
constexpr Use kRead{"read", [](const MapFormat& f) { return bool(f.read); }};
constexpr Use kWrite{"write", [](const MapFormat& f) { return bool(f.write); }};

/// The names or suffixes of the formats that can be used so.
template <class Name>
std::string possible(const MapFormats& formats, const Use& use, Name name) {
  std::vector<std::string> known;
  for (const MapFormat& format : formats)
    if (use.possible(format)) name(format, known);
  return fmt::format("{}", fmt::join(known, ", "));
}

/// By name, else by the file's suffix.
const MapFormat& chosen_format(const std::string& file, const std::string& name, const MapFormats& formats,
                               const Use& use) {
  if (!name.empty() || file == kStandardStream) {
    const MapFormat& format = formats.find(name.empty() ? kStreamFormat : name);
    if (use.possible(format)) return format;
    throw_invalid("cannot {} maps in the format '{}', expected one of: {}", use.verb, format.name,
                  possible(formats, use, [](const MapFormat& f, auto& known) { known.push_back(f.name); }));
  }
  const std::string suffix = suffix_of(file);
  for (const MapFormat& format : formats)
    if (use.possible(format) && std::ranges::count(format.suffixes, suffix) > 0) return format;
  throw_invalid("cannot {} '{}': its name must end in one of: {}", use.verb, file,
                possible(formats, use, [](const MapFormat& f, auto& known) {
                  known.insert(known.end(), f.suffixes.begin(), f.suffixes.end());
                }));
}

}  // namespace

std::vector<ParameterInfo> reader_parameters(const MapFormats& formats) {
  std::vector<ParameterInfo> all;
  for (const MapFormat& format : formats)
    for (const ParameterInfo& parameter : format.parameters)
      if (std::ranges::count(all, parameter.name, &ParameterInfo::name) == 0) all.push_back(parameter);
  return all;
}

MapFile read_map(const std::string& file, const Settings& settings, const MapFormats& formats,
                 const std::string& format_name) {
  struct stat about {};
  if (file != kStandardStream && (::stat(file.c_str(), &about) != 0 || S_ISDIR(about.st_mode)))
    (void)read_file(file);  // throws the reason
  const Settings all = checked("a map reader", reader_parameters(formats), settings);
  const MapFormat& format = chosen_format(file, format_name, formats, kRead);
  Settings own;
  std::vector<std::string> unused;
  for (const auto& [name, value] : all)
    if (std::ranges::count(format.parameters, name, &ParameterInfo::name) > 0)
      own[name] = value;
    else
      unused.push_back(fmt::format("'{}' is not a parameter of format '{}' and is not used", name, format.name));
  MapFile result = format.read(file, own);
  result.remarks.insert(result.remarks.end(), unused.begin(), unused.end());
  return result;
}

const MapFormat& format_to_write(const std::string& file, const MapFormats& formats, const std::string& format) {
  return chosen_format(file, format, formats, kWrite);
}

void write_map(const std::string& file, const MapFile& map, const MapFormats& formats, const std::string& format) {
  write_file(file, format_to_write(file, formats, format).write(map));
}

std::string stem_of(const std::string& file) {
  return file == kStandardStream ? "stdin" : std::filesystem::path(file).stem().string();
}

}  // namespace oxturn
