/// A new folder that goes, with all it holds, when its object does.
///
///   const TemporaryFolder folder;
///   write_file(folder.file("map.geojson"), text);
#pragma once

#include <filesystem>
#include <string>

namespace oxturn {

class TemporaryFolder {
 public:
  /// In TMPDIR, or in /tmp. Throws std::runtime_error if none can be made.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace oxturn
