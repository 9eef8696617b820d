// [[planners]]: names with parameters.
//
// Decisions  1. "*" means every planner that is not listed already with the same settings.
//            2. A setting equal to the default is dropped: `zigzag[margin=0]` and `zigzag` are one variant.
//            3. ignore_tether is a key of the suite, not a parameter: it says what the planner is given, and how its
//               path is judged.
//            4. `exec` in place of `name` adds an external planner, whose command is started in the suite's folder. "*"
//               means the planners that were there before: those of the suite have an entry of their own.
#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "bench/external_planner.hpp"
#include "bench/run_id.hpp"
#include "bench/suite_parts.hpp"

namespace oxturn {
namespace {

// A planner that runs another one has more parameters, which its own settings tell.
std::vector<ParameterInfo> parameters_for(const std::string& file, const PlannerInfo& planner,
                                          const std::vector<Choice>& chosen, const Planners& planners) {
  if (!planner.more_parameters) return planner.parameters;
  std::vector<Choice> own;
  for (const Choice& choice : chosen)
    for (const ParameterInfo& parameter : planner.parameters)
      if (choice.first == parameter.name) own.push_back(choice);
  const Settings settings =
      settings_of(file, fmt::format("planner '{}'", planner.name), planner.parameters, own, Defaults::keep);
  std::vector<ParameterInfo> all;
  const auto ask = [&] { all = parameters_of(planner, settings, planners); };
  if (own.empty())
    ask();
  else
    at_position(file, *own.front().second, ask);
  return all;
}

/// The values of ignore_tether; one `false` if the key is missing.
std::vector<bool> read_ignored(const std::string& file, TomlTable& table) {
  const toml::node* node = table.find(kIgnoreTether);
  if (node == nullptr) return {false};
  std::vector<bool> all;
  for (const toml::node* item : alternatives(file, *node, kIgnoreTether))
    all.push_back(truth(file, *item, kIgnoreTether));
  return all;
}

/// Gathers the variants of a suite, each once.
class PlannerReader {
 public:
  PlannerReader(const std::string& file, Planners& planners)
      : file_(file), planners_(planners), built_in_(planners.size()) {}

  void read(const toml::table& section) {
    TomlTable table(file_, section, "[[planners]]");
    const std::vector<bool> ignored = read_ignored(file_, table);
    const toml::node* commands = table.find("exec");
    if (commands != nullptr && section.contains("name"))
      refuse(file_, *commands, "exec stands beside name; a program tells its name itself, leave it out");
    const std::string key = commands != nullptr ? "exec" : "name";
    const auto names = alternatives(file_, commands != nullptr ? *commands : table.need("name"), key);
    const auto combinations = product(file_, table.rest());
    for (const toml::node* node : names) {
      const auto* text = node->as_string();
      if (text == nullptr) refuse(file_, *node, key + " is not a text in quotes");
      const std::string name = commands != nullptr ? add_program(*node, text->get()) : text->get();
      const Entry entry{section, *node, name == "*"};
      for (const PlannerInfo* planner : named(entry, name))
        for (const auto& chosen : combinations) add_all(entry, *planner, chosen, ignored);
    }
  }
  std::vector<PlannerSpec> take() { return std::move(specs_); }

 private:
  struct Entry {
    const toml::table& section;
    const toml::node& name;
    bool every;  // the name is "*"
  };

  std::string add_program(const toml::node& node, const std::string& command) {
    std::string name;
    const std::string folder = std::filesystem::path(file_).parent_path().string();
    at_position(file_, node, [&] { name = add_external_planner(planners_, {command, folder}); });
    return name;
  }

  std::vector<const PlannerInfo*> named(const Entry& entry, const std::string& name) const {
    std::vector<const PlannerInfo*> all;
    if (entry.every)
      for (std::size_t i = 0; i < built_in_; ++i) all.push_back(&planners_[i]);
    else
      at_position(file_, entry.name, [&] { all.push_back(&planners_.find(name)); });
    return all;
  }

  void add_all(const Entry& entry, const PlannerInfo& planner, const std::vector<Choice>& chosen,
               const std::vector<bool>& ignored) {
    const auto parameters = parameters_for(file_, planner, chosen, planners_);
    const bool tethered = planner.has(Capability::tether);
    PlannerSpec spec{planner.name,
                     settings_of(file_, fmt::format("planner '{}'", planner.name), parameters, chosen, Defaults::drop)};
    // Throws for settings that exclude each other.
    at_position(file_, entry.name, [&] { planner.make(spec.settings, planners_); });
    for (const bool ignore : ignored) {
      if (ignore && tethered && !entry.every)
        refuse(
            file_, entry.name,
            fmt::format("planner '{}' plans for the tether, so ignore_tether = true does not apply to it; leave it out",
                        planner.name));
      spec.ignore_tether = ignore && !tethered;
      add(entry, spec);
    }
  }

  void add(const Entry& entry, const PlannerSpec& spec) {
    if (variants_.insert(spec.variant()).second)
      specs_.push_back(spec);
    else if (!entry.every)
      refuse(file_, entry.section, fmt::format("planner variant '{}' is listed twice", spec.variant()));
  }

  const std::string& file_;
  Planners& planners_;
  std::size_t built_in_;  // how many there were before
  std::vector<PlannerSpec> specs_;
  std::set<std::string> variants_;
};

}  // namespace

std::vector<PlannerSpec> read_planners(const std::string& file, const toml::node* node, const toml::table& root,
                                       Planners& planners) {
  if (node == nullptr) refuse(file, root, "no [[planners]]; a suite needs at least one, for instance name = \"*\"");
  const toml::array* list = node->as_array();
  if (list == nullptr || list->empty()) refuse(file, *node, "planners is no list of tables; write [[planners]]");
  PlannerReader reader(file, planners);
  for (const toml::node& item : *list) {
    if (!item.is_table()) refuse(file, item, "planners is no list of tables; write [[planners]]");
    reader.read(*item.as_table());
  }
  return reader.take();
}

}  // namespace oxturn
