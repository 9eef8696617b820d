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

MapFormats built_in_map_formats() {
  return MapFormats("map format", {ros_format(), geojson_format(), image_format(), svg_format()});
}

std::string suffix_of(const std::string& file) { return lower_case(std::filesystem::path(file).extension().string()); }

namespace {

/// The format with this suffix among those with usable(format); `known` collects all their suffixes.
template <class F>
const MapFormat* format_with(const std::string& suffix, const MapFormats& formats, F usable,
                             std::vector<std::string>& known) {
  const MapFormat* found = nullptr;
  for (const MapFormat& format : formats) {
    if (!usable(format)) continue;
    known.insert(known.end(), format.suffixes.begin(), format.suffixes.end());
    if (found == nullptr && std::find(format.suffixes.begin(), format.suffixes.end(), suffix) != format.suffixes.end())
      found = &format;
  }
  return found;
}

}  // namespace

std::vector<ParameterInfo> reader_parameters(const MapFormats& formats) {
  std::vector<ParameterInfo> all;
  for (const MapFormat& format : formats)
    for (const ParameterInfo& parameter : format.parameters)
      if (std::ranges::count(all, parameter.name, &ParameterInfo::name) == 0) all.push_back(parameter);
  return all;
}

MapFile read_map(const std::string& file, const Settings& settings, const MapFormats& formats) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0 || S_ISDIR(about.st_mode)) (void)read_file(file);  // throws the reason
  const Settings all = checked("a map reader", reader_parameters(formats), settings);
  std::vector<std::string> known;
  const std::string suffix = suffix_of(file);
  const MapFormat* format = format_with(
      suffix, formats, [](const MapFormat& f) { return bool(f.read); }, known);
  if (format == nullptr)
    throw_invalid("{}: unknown kind of map '{}', expected one of: {}", file, suffix, fmt::join(known, ", "));
  Settings own;
  std::vector<std::string> unused;
  for (const auto& [name, value] : all)
    if (std::ranges::count(format->parameters, name, &ParameterInfo::name) > 0)
      own[name] = value;
    else
      unused.push_back(fmt::format("'{}' is not a parameter of format '{}' and is not used", name, format->name));
  MapFile result = format->read(file, own);
  result.remarks.insert(result.remarks.end(), unused.begin(), unused.end());
  return result;
}

const MapFormat& format_to_write(const std::string& file, const MapFormats& formats) {
  std::vector<std::string> known;
  const MapFormat* format = format_with(
      suffix_of(file), formats, [](const MapFormat& f) { return bool(f.write); }, known);
  if (format == nullptr)
    throw_invalid("cannot write '{}': its name must end in one of: {}", file, fmt::join(known, ", "));
  return *format;
}

void write_map(const std::string& file, const MapFile& map, const MapFormats& formats) {
  write_file(file, format_to_write(file, formats).write(map));
}

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

}  // namespace oxturn
