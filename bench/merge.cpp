// Decisions  1. Parts are taken in the order of their shards, which is the order of the suite.
//            2. Of a run one row is kept: the last attempt of a part, of several parts the first that is neither
//               cancelled nor infrastructure. Rows that ended by a limit are not compared: machines differ.
//            3. Files are linked where the file system can, and copied elsewhere.
#include "bench/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/throw_invalid.hpp"
#include "bench/csv_records.hpp"
#include "bench/run_id.hpp"
#include "bench/run_lines.hpp"
#include "bench/session_file.hpp"
#include "bench/worker.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

struct Part {
  std::string folder;
  SessionFile session;
};

std::vector<Part> read_parts(const std::vector<std::string>& folders) {
  std::vector<Part> parts;
  for (const std::string& folder : folders) parts.push_back({folder, read_session_file(folder)});
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return a.session.shard.range(a.session.runs).first < b.session.shard.range(b.session.runs).first;
  });
  return parts;
}

void require_same(const Part& a, const Part& b) {
  const auto compare = [&](const char* what, const std::string& first, const std::string& second) {
    if (first != second)
      throw_invalid("'{}' and '{}' have different {} ({}, {}); only parts of one suite by one build can be merged",
                    a.folder, b.folder, what, first, second);
  };
  compare("suites", a.session.suite, b.session.suite);
  compare("builds of oxturn", a.session.build_identity(), b.session.build_identity());
  compare("builds that scored", a.session.scoring_identity(), b.session.scoring_identity());
  compare("contents of the suite", a.session.suite_identity, b.session.suite_identity);
  const auto metrics = [](const Part& part) {
    std::string text;
    for (const OutsideEntry& metric : part.session.metrics) text += metric.name + " " + metric.identity + " ";
    return text;
  };
  compare("metrics of plug-ins", metrics(a), metrics(b));
}

/// Where the row of a run is.
struct Kept {
  std::size_t part = 0;
  std::streamoff begin = 0;  // in the part's runs.csv
  std::size_t size = 0;      // bytes, line break included
};

class Merger {
 public:
  Merger(std::vector<Part> parts, std::string folder) : parts_(std::move(parts)), folder_(std::move(folder)) {}

  Merged run() {
    for (std::size_t i = 0; i < parts_.size(); ++i) read_rows(i);
    fs::create_directories(folder_);
    write_rows();
    for (const char* name : {"trace.csv", "metrics.csv"}) write_lines(name);
    for (const char* kind : {"paths", "pictures", "traces", "tethers", "logs", "maps"})
      for (std::size_t i = 0; i < parts_.size(); ++i) link_files(kind, i);
    write_session();
    merged_.runs = order_.size();
    merged_.wanted = parts_.front().session.runs;
    return merged_;
  }

 private:
  Row row_of(const std::string& line) const { return rows_from_csv(header_ + line, "a row").front(); }

  void read_rows(std::size_t part) {
    const std::string file = parts_[part].folder + "/runs.csv";
    files_.emplace_back(file, std::ios::binary);
    std::streamoff begin = 0;
    for_each_record(file, [&](const std::string& line) {
      const Kept here{part, std::exchange(begin, begin + static_cast<std::streamoff>(line.size())), line.size()};
      if (here.begin > 0) return take(here, line);
      if (header_.empty()) header_ = line;
      if (line != header_)
        throw_invalid("{}: its columns are not those of '{}'", file, parts_.front().folder + "/runs.csv");
      columns_ = parse_csv(header_, file).front();
    });
  }

  std::string line_of(const Kept& kept) {
    std::string line(kept.size, '\0');
    std::ifstream& in = files_[kept.part];
    if (!in.seekg(kept.begin).read(line.data(), static_cast<std::streamsize>(line.size())))
      throw std::runtime_error(fmt::format("cannot read '{}/runs.csv' again", parts_[kept.part].folder));
    return line;
  }

  void take(const Kept& here, const std::string& line) {
    const Row row = row_of(line);
    const auto [known, fresh] = kept_.emplace(row.get("run_id"), here);
    if (fresh) return order_.push_back(known);
    ++merged_.duplicates;
    const Row before = row_of(line_of(known->second));
    if (known->second.part != here.part && !is_unfinished(before.outcome()))
      return compare(before, known->second.part, row, here.part);
    known->second = here;
  }

  static bool depends_on_the_machine(const Row& row) {
    return is_unfinished(row.outcome()) || row.outcome() == Outcome::timeout || row.outcome() == Outcome::out_of_memory;
  }

  void compare(const Row& a, std::size_t part_a, const Row& b, std::size_t part_b) const {
    if (depends_on_the_machine(a) || depends_on_the_machine(b)) return;
    static const std::set<std::string> varying = [] {
      std::set<std::string> names{"attempt"};
      for (const Column& column : run_columns(Metrics("metric")))
        if (column.timing) names.insert(column.name);
      return names;
    }();
    for (const std::string& column : columns_)
      if (varying.count(column) == 0 && a.get(column) != b.get(column))
        throw_invalid("run {} ({} on {}) has {} '{}' in '{}' and '{}' in '{}'; the planner is not deterministic",
                      a.get("run_id"), a.get("variant"), a.get("map"), column, a.get(column), parts_[part_a].folder,
                      b.get(column), parts_[part_b].folder);
  }

  std::ofstream opened(const std::string& name) const {
    std::ofstream out(folder_ + "/" + name, std::ios::binary);
    if (!out) throw std::runtime_error(fmt::format("cannot write '{}/{}'", folder_, name));
    return out;
  }
  void close(std::ofstream& out, const std::string& name) const {
    out.close();
    if (!out) throw std::runtime_error(fmt::format("cannot write '{}/{}'", folder_, name));
  }

  void write_rows() {
    std::ofstream out = opened("runs.csv");
    out << header_;
    for (const auto& run : order_) out << line_of(run->second);
    close(out, "runs.csv");
    write_file(folder_ + "/columns.json", read_file(parts_.front().folder + "/columns.json"));
  }

  bool is_from(const std::string& run_id, std::size_t part) const {
    const auto run = kept_.find(run_id);
    return run != kept_.end() && run->second.part == part;
  }

  /// Of trace.csv or metrics.csv.
  void write_lines(const std::string& name) const {
    std::ofstream out;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::string file = parts_[i].folder + "/" + name;
      if (!fs::exists(file)) continue;
      for_each_record(file, [&](const std::string& line) {
        const bool header = line.starts_with("run_id,");
        if (header && !out.is_open()) {
          out = opened(name);
          out << line;
        }
        if (!header && is_from(line.substr(0, line.find(',')), i)) out << line;
      });
    }
    if (out.is_open()) close(out, name);
  }

  void link_files(const std::string& kind, std::size_t part) const {
    const fs::path from = fs::path(parts_[part].folder) / kind, to = fs::path(folder_) / kind;
    if (!fs::is_directory(from)) return;
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
      const fs::path target = to / entry.path().filename();
      if (kind != "maps" && !is_from(entry.path().stem().string(), part)) continue;
      if (fs::exists(target)) continue;
      std::error_code error;
      fs::create_hard_link(entry.path(), target, error);
      if (error) fs::copy_file(entry.path(), target);
    }
  }

  void write_session() const {
    SessionFile session = parts_.front().session;
    session.shard = {};
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const auto& more = parts_[i].session.sessions;
      session.sessions.insert(session.sessions.end(), more.begin(), more.end());
    }
    write_session_file(folder_, session);
  }

  std::vector<Part> parts_;
  std::vector<std::ifstream> files_;  // runs.csv of each part
  std::string folder_, header_;
  std::vector<std::string> columns_;
  std::map<std::string, Kept> kept_;  // by run_id
  std::vector<std::map<std::string, Kept>::iterator> order_;
  Merged merged_;
};

}  // namespace

Merged merge(const std::vector<std::string>& folders, const std::string& folder) {
  if (folders.empty()) throw_invalid("no folders to merge");
  if (fs::exists(folder + "/runs.csv")) throw_invalid("'{}' already holds results; choose another folder", folder);
  std::vector<Part> parts = read_parts(folders);
  for (const Part& part : parts) require_same(parts.front(), part);
  return Merger(std::move(parts), folder).run();
}

std::vector<MissingRun> missing_runs(const Suite& given, const Planners& planners,
                                     const std::vector<std::string>& folders) {
  Suite suite = given;
  name_maps(suite.maps);
  const auto key = [](const std::string& map, const std::string& robot, const std::string& variant,
                      const std::string& repeat) {
    return csv_line({map, robot, variant, repeat});
  };
  std::set<std::string> done;
  for (const std::string& folder : folders) {
    if (read_session_file(folder).suite_identity != suite_identity(suite, planners))
      throw_invalid("'{}' holds results of another suite, or of other contents of this one", folder);
    std::string header;
    for_each_record(folder + "/runs.csv", [&](const std::string& line) {
      if (header.empty()) {
        header = line;
        return;
      }
      const Row row = rows_from_csv(header + line, folder + "/runs.csv").front();
      if (!is_unfinished(row.outcome()))
        done.insert(key(row.get("map"), row.get("robot"), row.get("variant"), row.get("repeat")));
    });
  }
  std::vector<MissingRun> missing;
  const std::vector<SuiteCell> cells = cells_of(suite);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& [map, robot, planner, repeat] = cells[i];
    MissingRun run{i, suite.maps[map].name, suite.robots[robot].name, suite.planners[planner].variant(), repeat};
    if (done.count(key(run.map, run.robot, run.variant, std::to_string(repeat))) == 0) missing.push_back(run);
  }
  return missing;
}

}  // namespace oxturn
