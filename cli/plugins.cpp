#include "cli/plugins.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "bench/plugin.hpp"

namespace oxturn::cli {
namespace {

constexpr std::string_view kOption = "--plugin";

}  // namespace

Registry with_plugins(Registry registry, int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--") break;
    if (word == kOption && i + 1 < argc)
      load_plugin(registry, argv[++i]);
    else if (word.starts_with(kOption) && word.substr(kOption.size()).starts_with('='))
      load_plugin(registry, std::string(word.substr(kOption.size() + 1)));
  }
  return registry;
}

void add_plugin_option(CLI::App& command) {
  command
      .add_option_function<std::vector<std::string>>(
          std::string(kOption), [](const std::vector<std::string>&) {},  // with_plugins() has loaded them
          "a shared object with planners, metrics, maps or formats of its own: docs/plug-ins.md (may be repeated)")
      ->allow_extra_args(false)
      ->take_all()
      ->type_name("FILE.so");
}

}  // namespace oxturn::cli
