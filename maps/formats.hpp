/// Map files in and out.
///
///   const MapFormats formats = built_in_map_formats();
///   MapFile file = read_map("kitchen.yaml", {{"drop_speckle", 0.02}}, formats);
///   write_map("kitchen.geojson", file, formats);
///
/// Readers throw std::invalid_argument "FILE[:LINE]: what is wrong, what was expected".
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "base/named_list.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// What a file holds: the map, and whatever else of a problem it says.
struct MapFile {
  Map map;
  std::optional<Point> start, anchor;
  std::optional<Robot> robot;
  std::vector<std::string> remarks;  // what the reader did that the user should know, one sentence each
};

/// A kind of file. Maps of this kind can be read, written, or both.
struct MapFormat {
  std::string name;  // "ros", "geojson"
  std::string title;
  std::vector<std::string> suffixes;                                               // ".yaml", ...
  std::vector<ParameterInfo> parameters;                                           // of reading
  std::function<MapFile(const std::string& file, const Settings& settings)> read;  // empty: cannot be read
  std::function<std::string(const MapFile& file)> write;                           // empty: cannot be written
};
using MapFormats = NamedList<MapFormat>;

/// The formats that come with oxturn; maps/formats/formats.cpp lists them.
MapFormats built_in_map_formats();

/// The parameters of all readers, each name once.
std::vector<ParameterInfo> reader_parameters(const MapFormats& formats);

/// Reads the file in the format of that name, or if it is empty in the one that the file's suffix names; standard input
/// (kStandardStream of base/files.hpp) is GeoJSON then. A setting that this format does not have but another one has
/// becomes a remark. Throws for a missing file, an unknown suffix (with the list), a bad setting or bad content.
MapFile read_map(const std::string& file, const Settings& settings, const MapFormats& formats,
                 const std::string& format = {});

/// Writes the file in the format of that name, or as read_map() in the one that its suffix names. Throws
/// std::invalid_argument for a suffix that cannot be written (with the list), std::runtime_error if the file cannot be.
void write_map(const std::string& file, const MapFile& map, const MapFormats& formats, const std::string& format = {});
/// Throws as write_map does for the suffix or the format's name, without writing.
const MapFormat& format_to_write(const std::string& file, const MapFormats& formats, const std::string& format = {});

/// ".yaml", in lower case.
std::string suffix_of(const std::string& file);

/// GeoJSON Feature with name, start, anchor, robot and source.
std::string to_geojson(const Problem& problem);
std::string to_geojson(const MapFile& map);

/// The description of a format that is read with the parameters of P.
template <class P>
MapFormat describe_format(std::string name, std::string title, std::vector<std::string> suffixes,
                          std::vector<Parameter<P>> lines, MapFile (*read)(const std::string&, const P&),
                          std::string (*write)(const MapFile&) = nullptr) {
  MapFormat format{name, std::move(title), std::move(suffixes), infos_of(lines), {}, {}};
  if (read != nullptr)
    format.read = [owner = "format '" + name + "'", lines = std::move(lines), read](const std::string& file,
                                                                                    const Settings& settings) {
      return read(file, with_settings<P>(owner, lines, settings));
    };
  if (write != nullptr) format.write = write;
  return format;
}

}  // namespace oxturn
