#include "bench/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace oxturn {

Progress::Progress(std::size_t total, bool shown) : total_(total), shown_(shown), terminal_(::isatty(2) == 1) {}

Progress::~Progress() {
  if (shown_ && drawn_) std::fputc('\n', stderr);
}

void Progress::ran(Outcome outcome) {
  ++done_;
  ++outcomes_[outcome];
  show(done_ == total_);
}

void Progress::remark(const std::string& sentence) {
  if (shown_) fmt::print(stderr, "{}{}\n", drawn_ ? "\n" : "", sentence);
}

std::string Progress::text() const {
  std::string out = fmt::format("{}/{} runs", done_, total_);
  for (const auto& [outcome, count] : outcomes_) out += fmt::format(", {} {}", count, to_text(outcome));
  return out;
}

void Progress::show(bool last) {
  if (!shown_ || total_ == 0) return;
  if (terminal_) {
    constexpr std::size_t kWidth = 30;
    const std::size_t full = kWidth * done_ / total_;
    fmt::print(stderr, "\r[{}{}] {}\033[K", std::string(full, '#'), std::string(kWidth - full, '.'), text());
    std::fflush(stderr);
    drawn_ = true;
    return;
  }
  const std::size_t tenth = 10 * done_ / total_;
  if (tenth == said_ && !last) return;
  said_ = tenth;
  fmt::print(stderr, "{}\n", text());
}

}  // namespace oxturn
