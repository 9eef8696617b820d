/// How far a suite is, on standard error: a bar on a terminal, otherwise a line at every tenth. Internal to bench/.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "bench/results.hpp"

namespace oxturn {

class Progress {
 public:
  Progress(std::size_t total, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  void kept() { ++done_; }
  void ran(Outcome outcome);
  void remark(const std::string& sentence);

 private:
  std::string text() const;
  void show(bool last);
  std::size_t total_, done_ = 0, said_ = 0;
  bool shown_, terminal_, drawn_ = false;
  std::map<Outcome, std::size_t> outcomes_;
};

}  // namespace oxturn
