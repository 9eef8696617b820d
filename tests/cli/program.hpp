// Runs the built program and keeps what it said.
#pragma once

#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/temporary_folder.hpp"

namespace oxturn {

class Folder : public TemporaryFolder {
 public:
  std::string operator/(const std::string& name) const { return file(name); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::recursive_directory_iterator(path()),
                                                  std::filesystem::recursive_directory_iterator()));
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }
};

inline std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Said {
  int code = -1;
  std::string out, err;
  auto err_lines() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// A command of the shell, in which `oxturn` is the program; the exit code of a pipe is that of its last command.
inline Said shell(const std::string& line) {
  const Folder folder;
  const std::string command = std::string("{ oxturn() { '") + OXTURN_PROGRAM + "' \"$@\"; }; " + line + "\n} >" +
                              (folder / "out") + " 2>" + (folder / "err") + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, content(folder / "out"), content(folder / "err")};
}

/// `arguments` are shell words.
inline Said oxturn(const std::string& arguments) { return shell("oxturn " + arguments); }

}  // namespace oxturn
