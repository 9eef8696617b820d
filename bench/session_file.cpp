#include "bench/session_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::ordered_json;

std::string file_of(const std::string& folder) { return folder + "/session.json"; }

/// A member as text; "unknown" if there is none.
std::string member(const Json& object, const char* key) {
  if (!object.is_object() || !object.contains(key)) return "unknown";
  const Json& value = object.at(key);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Json to_json(const SessionEntry& entry) {
  return {{"started", entry.started},
          {"machine", entry.machine},
          {"jobs", entry.jobs},
          {"isolation", {{"kill", entry.isolation.kill}, {"memory", entry.isolation.memory}}},
          {"command_line", entry.command_line}};
}

SessionEntry entry_from(const Json& json) {
  const Json isolation = json.value("isolation", Json::object());  // results of older versions have none
  return {json.at("started"),
          json.at("machine"),
          json.at("jobs"),
          json.at("command_line"),
          {isolation.value("kill", ""), isolation.value("memory", "")}};
}

SessionFile session_from(const Json& json) {
  SessionFile session;
  session.suite = json.at("suite");
  session.suite_file = json.at("suite_file");
  session.suite_identity = json.at("suite_identity");
  session.runs = json.at("runs");
  session.shard = parse_shard(json.at("shard"));
  const Json& limits = json.at("limits");
  session.limits = {limits.at("wall_s"), limits.at("cpu_s"), limits.at("memory_mb")};
  session.warm_ups = json.at("warm_ups");
  session.target_coverage = json.at("target_coverage");
  for (const auto& [name, robot] : json.at("robots").items()) session.robots.emplace_back(name, robot);
  session.build = json.at("build");
  session.rescored = json.value("rescored", Json());
  for (const Json& p : json.value("programs", Json::array()))
    session.programs.push_back({p.at("planner"), p.at("command"), p.at("identity")});
  for (const Json& m : json.value("plugin_metrics", Json::array()))
    session.metrics.push_back({m.at("metric"), m.at("plugin"), m.at("identity")});
  for (const Json& entry : json.at("sessions")) session.sessions.push_back(entry_from(entry));
  return session;
}

}  // namespace

std::string SessionFile::build_identity() const { return member(build, "identity"); }
std::string SessionFile::scoring_identity() const { return member(rescored.is_null() ? build : rescored, "identity"); }

SessionFile read_session_file(const std::string& folder) {
  const std::string text = read_file(file_of(folder));
  try {
    return session_from(Json::parse(text));
  } catch (const Json::exception& e) {
    throw std::invalid_argument(fmt::format(
        "{}: not what this version of `oxturn run` writes ({}); choose another folder", file_of(folder), e.what()));
  }
}

void write_session_file(const std::string& folder, const SessionFile& session) {
  Json json{{"schema", 1},
            {"suite", session.suite},
            {"suite_file", session.suite_file},
            {"suite_identity", session.suite_identity},
            {"runs", session.runs},
            {"shard", session.shard.text()}};
  json["limits"] = {
      {"wall_s", session.limits.wall_s}, {"cpu_s", session.limits.cpu_s}, {"memory_mb", session.limits.memory_mb}};
  json["warm_ups"] = session.warm_ups;
  json["target_coverage"] = session.target_coverage;
  json["robots"] = Json::object();
  for (const auto& [name, robot] : session.robots) json["robots"][name] = robot;
  json["build"] = session.build;
  if (!session.rescored.is_null()) json["rescored"] = session.rescored;
  if (!session.programs.empty()) json["programs"] = Json::array();
  for (const OutsideEntry& p : session.programs)
    json["programs"].push_back({{"planner", p.name}, {"command", p.origin}, {"identity", p.identity}});
  if (!session.metrics.empty()) json["plugin_metrics"] = Json::array();
  for (const OutsideEntry& m : session.metrics)
    json["plugin_metrics"].push_back({{"metric", m.name}, {"plugin", m.origin}, {"identity", m.identity}});
  json["sessions"] = Json::array();
  for (const SessionEntry& entry : session.sessions) json["sessions"].push_back(to_json(entry));
  write_file(file_of(folder), json_text(json));
}

std::vector<std::string> summary(const SessionFile& session) {
  const Limits& limits = session.limits;
  std::vector<std::string> lines{
      fmt::format("Limits of each run: {} s wall time, {}{} MB of memory; target coverage {}",
                  to_decimal(limits.wall_s), limits.cpu_s > 0 ? to_decimal(limits.cpu_s) + " s processor time, " : "",
                  to_decimal(limits.memory_mb), to_decimal(session.target_coverage))};
  for (const auto& [name, robot] : session.robots) lines.push_back(fmt::format("Robot {}: {}", name, robot));
  if (session.sessions.empty()) return lines;
  const SessionEntry& last = session.sessions.back();
  lines.push_back(fmt::format("Machine: {}, {} cores, {} at a time; build {} ({})", member(last.machine, "cpu"),
                              member(last.machine, "cores"), last.jobs, member(session.build, "revision"),
                              session.build_identity()));
  if (!session.rescored.is_null())
    lines.push_back(
        fmt::format("Scored again by build {} ({})", member(session.rescored, "revision"), session.scoring_identity()));
  return lines;
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace oxturn
