/// The suites that come with oxturn.
#pragma once

#include <string>
#include <vector>

namespace oxturn::cli {

struct SuiteFile {
  std::string name, file;
  std::string title;  // the first comment line
};
/// *.toml of the suites' folder, by name: share/oxturn/suites beside the program's folder, else bench/suites of the
/// source tree. Empty if there is neither.
std::vector<SuiteFile> suite_files();
/// The name of a file, or standard input, as it is; a name without dots and slashes ("quick") is looked up among
/// suite_files().
std::string find_suite(const std::string& name);

}  // namespace oxturn::cli
