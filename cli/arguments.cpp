#include "cli/arguments.hpp"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn::cli {

namespace fs = std::filesystem;

void add_settings(CLI::App& app, std::vector<std::string>& assignments, const std::string& of_what,
                  const std::string& list) {
  app.add_option(
         "--set", assignments,
         "parameter of the " + of_what + ", name=value; `oxturn list " + list + " NAME` shows them (may be repeated)")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("K=V");
}

Settings parse_settings(const std::string& owner, const std::vector<ParameterInfo>& parameters,
                        const std::vector<std::string>& assignments, const std::string& given_by) {
  Settings settings;
  for (const std::string& text : assignments) {
    const auto [name, value] = assignment(given_by, text);
    settings[name] = parse_value(owner, find_parameter(owner, parameters, name), value);
  }
  return settings;
}

std::pair<std::string, std::string> assignment(const std::string& option, const std::string& text) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0)
    throw std::invalid_argument(fmt::format("{} '{}': expected name=value", option, text));
  return {text.substr(0, at), text.substr(at + 1)};
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= text.size(); ++i)
    if (i == text.size() || text[i] == at) {
      parts.push_back(text.substr(from, i - from));
      from = i + 1;
    }
  return parts;
}

bool file_exists(const std::string& name) {
  std::error_code error;
  return fs::exists(name, error);
}

bool is_standard_stream(const std::string& file) { return file == kStandardStream; }

void require_one_stream(const std::vector<NamedFile>& files, const std::string& stream) {
  const NamedFile* first = nullptr;
  for (const NamedFile& file : files) {
    if (!is_standard_stream(file.file)) continue;
    if (first != nullptr)
      throw std::invalid_argument(
          fmt::format("{} and {} are both '-', {}, which carries one file; name a file for one of them", first->option,
                      file.option, stream));
    first = &file;
  }
}

std::FILE* print_to(const std::vector<std::string>& files) {
  return std::any_of(files.begin(), files.end(), is_standard_stream) ? stderr : stdout;
}

namespace {

bool has_suffix(const std::string& file, const std::string& suffix) {
  if (file.size() < suffix.size()) return false;
  for (std::size_t i = 0; i < suffix.size(); ++i) {
    const char c = file[file.size() - suffix.size() + i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != suffix[i]) return false;
  }
  return true;
}

}  // namespace

void require_suffix(const std::string& file, const std::vector<std::string>& suffixes) {
  if (is_standard_stream(file)) return;
  for (const std::string& s : suffixes)
    if (has_suffix(file, s)) return;
  throw std::invalid_argument(
      fmt::format("cannot write '{}': its name must end in {}", file, fmt::join(suffixes, " or ")));
}

void require_writable(const std::string& file) {
  if (is_standard_stream(file)) return;
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("cannot write '{}': {}", file, why));
  };
  std::error_code error;
  if (file.empty() || fs::is_directory(file, error)) refuse("that is a folder, expected a file's name");
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {  // a device or pipe: written straight
    if (access(file.c_str(), W_OK) != 0) refuse(std::strerror(errno));
    return;
  }
  const fs::path parent = fs::path(file).has_parent_path() ? fs::path(file).parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error)) refuse(fmt::format("there is no folder '{}'", parent.string()));
  std::string probe = (parent / ".oxturn-XXXXXX").string();
  const int handle = mkstemp(probe.data());
  if (handle < 0) refuse(std::strerror(errno));
  close(handle);
  unlink(probe.c_str());
}

void say(const std::string& sentence) { fmt::print(stderr, "oxturn: {}\n", sentence); }

CLI::Validator number_from(double least, bool included, const std::string& unit) {
  return CLI::Validator(
      [=](std::string& text) -> std::string {
        const auto value = parse_number(text);
        if (value && (included ? *value >= least : *value > least)) return {};
        return fmt::format("is '{}', expected {}{} {:g}", text, unit, included ? " from" : " above", least);
      },
      "");
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) -> std::string {
        if (parse_whole(text)) return {};
        return fmt::format("is '{}', expected a whole number from 0 to 18446744073709551615", text);
      },
      "");
}

}  // namespace oxturn::cli
