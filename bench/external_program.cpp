// Decisions  1. One loop reads output and errors and writes input: a program that publishes before it has read all of
//               its problem does not block, nor one that prints errors without end.
//            2. The limit on address space is lifted for the program: runtimes of many languages reserve more than they
//               use. The supervisor measures what it uses.
#include "bench/external_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "base/text.hpp"
#include "bench/process_info.hpp"

namespace oxturn {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kChunk = 1 << 16;
constexpr std::size_t kKeptWords = 4096;  // of standard error
constexpr std::size_t kShown = 80;        // bytes of a line or command in messages
constexpr int kWatchMs = 10;              // between two readings of memory
constexpr int kShellSignal = 128;         // and the signal's number: exit code of a shell

std::string shortened(std::string_view text) {
  return printable(text.substr(0, kShown)) + (text.size() > kShown ? "..." : "");
}

[[noreturn]] void cannot_start(const ShellCommand& command) {
  throw std::runtime_error(fmt::format("cannot start {}: {}", quoted(command), std::strerror(errno)));
}

/// In the forked process.
[[noreturn]] void become(const ShellCommand& command, pid_t parent, int input, int output, int errors) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  ::dup2(input, 0);
  ::dup2(output, 1);
  ::dup2(errors, 2);
  ::signal(SIGPIPE, SIG_DFL);
  rlimit space{};
  ::getrlimit(RLIMIT_AS, &space);
  space.rlim_cur = space.rlim_max;
  ::setrlimit(RLIMIT_AS, &space);
  if (!command.folder.empty() && ::chdir(command.folder.c_str()) != 0) ::_exit(126);
  ::execl("/bin/sh", "sh", "-c", command.text.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

void do_not_block(const wire::Descriptor& fd) {
  ::fcntl(fd.number(), F_SETFL, ::fcntl(fd.number(), F_GETFL) | O_NONBLOCK);
}

/// Reads what is there, up to `most` bytes; closes the descriptor at its end.
template <class Take>
void read_some(wire::Descriptor& fd, std::size_t most, Take take) {
  std::array<char, kChunk> chunk;
  for (std::size_t total = 0; fd.open() && total < most;) {
    const ssize_t got = ::read(fd.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return;  // nothing more for now
    if (got == 0) return fd.close();
    total += static_cast<std::size_t>(got);
    take(std::string_view(chunk.data(), static_cast<std::size_t>(got)));
  }
}

}  // namespace

std::string quoted(const ShellCommand& command) { return "`" + shortened(command.text) + "`"; }

std::string beginning_of(std::string_view text) { return "'" + shortened(text) + "'"; }

ExternalProgram::ExternalProgram(const ShellCommand& command) {
  std::signal(SIGPIPE, SIG_IGN);  // a program that reads no further is no reason to die
  wire::Pipe input = wire::make_pipe(), output = wire::make_pipe(), errors = wire::make_pipe();
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ < 0) cannot_start(command);
  if (pid_ == 0) become(command, parent, input.read.number(), output.write.number(), errors.write.number());
  process_ = wire::Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0)));
  input_ = std::move(input.write);
  output_ = std::move(output.read);
  errors_ = std::move(errors.read);
  for (const wire::Descriptor* fd : {&input_, &output_, &errors_}) do_not_block(*fd);
}

ExternalProgram::~ExternalProgram() {
  try {
    wait(0);
  } catch (...) {  // memory is lacking: the supervisor kills what is left
  }
}

void ExternalProgram::send(std::string text) {
  pending_ = std::move(text);
  written_ = 0;
}

void ExternalProgram::close_input() { input_.close(); }

void ExternalProgram::write_input() {
  while (input_.open() && written_ < pending_.size()) {
    const ssize_t put = ::write(input_.number(), pending_.data() + written_, pending_.size() - written_);
    if (put < 0 && errno == EINTR) continue;
    if (put < 0 && errno == EAGAIN) return;
    if (put < 0) return input_.close();
    written_ += static_cast<std::size_t>(put);
  }
  pending_ = {};
  written_ = 0;
}

void ExternalProgram::read_output() {
  read_some(output_, kChunk * 16, [this](std::string_view chunk) {
    if (!dropping_) buffer_ += chunk;
  });
}

void ExternalProgram::read_errors() {
  read_some(errors_, kChunk, [this](std::string_view chunk) {
    words_ += chunk;
    if (words_.size() > kKeptWords) words_.erase(0, words_.size() - kKeptWords);
    [[maybe_unused]] const ssize_t passed = ::write(STDERR_FILENO, chunk.data(), chunk.size());
  });
}

void ExternalProgram::look_at_memory() {
  if (lines_ == 0) return;  // it may not have begun yet: until then it is a copy of this process
  double memory = 0;
  for (const pid_t p : descendants(::getpid())) memory += peak_resident_bytes(p);
  peak_ = std::max(peak_, memory);
}

bool ExternalProgram::poll_all(int milliseconds) {
  std::array<pollfd, 4> fds{{{output_.number(), POLLIN, 0},
                             {errors_.number(), POLLIN, 0},
                             {pending_.empty() ? -1 : input_.number(), POLLOUT, 0},
                             {process_.number(), POLLIN, 0}}};
  ::poll(fds.data(), fds.size(), milliseconds);
  look_at_memory();
  read_errors();
  if (!pending_.empty()) write_input();
  const std::size_t before = buffer_.size();
  read_output();
  // A process that it has left behind may hold its output open.
  const bool ended = fds[3].revents != 0 || !process_.open();
  return output_.open() && !(ended && buffer_.size() == before);
}

bool ExternalProgram::take_line() {
  const std::size_t end = buffer_.find('\n', searched_);
  if (end == std::string::npos) {  // what has been taken is dropped now, not line by line
    buffer_.erase(0, taken_);
    taken_ = 0;
    searched_ = buffer_.size();
    return false;
  }
  line_ = buffer_.substr(taken_, end - taken_);
  taken_ = searched_ = end + 1;
  ++lines_;
  return true;
}

ExternalProgram::Next ExternalProgram::next_line(double seconds) {
  const auto begin = Clock::now();
  for (bool more = true;;) {
    if (take_line()) return Next::line;
    if (buffer_.size() > kLongestLine) {
      line_ = buffer_.substr(0, kShown + 1);
      return Next::too_long;
    }
    if (!more) {
      line_ = std::move(buffer_);
      buffer_.clear();
      return Next::closed;
    }
    if (seconds >= 0 && std::chrono::duration<double>(Clock::now() - begin).count() >= seconds) return Next::late;
    more = poll_all(kWatchMs);
  }
}

bool ExternalProgram::reap() {
  if (end_) return true;
  int status = 0;
  if (::waitpid(pid_, &status, WNOHANG) != pid_) return false;
  end_.emplace();
  if (WIFEXITED(status)) end_->exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end_->signal = WTERMSIG(status);
  // By this the shell tells that the program was killed.
  if (end_->exit_code > kShellSignal && end_->exit_code - kShellSignal < NSIG) {
    end_->signal = end_->exit_code - kShellSignal;
    end_->exit_code = 0;
  }
  return true;
}

ExternalProgram::End ExternalProgram::wait(double seconds) {
  const auto begin = Clock::now();
  input_.close();
  dropping_ = true;
  pending_ = buffer_ = std::string();
  taken_ = searched_ = 0;
  bool killed = false;
  while (!reap()) {
    if (!killed && std::chrono::duration<double>(Clock::now() - begin).count() >= seconds) {
      killed = true;
      for (const pid_t p : descendants(pid_)) ::kill(p, SIGKILL);
      ::kill(pid_, SIGKILL);
    }
    poll_all(kWatchMs);
  }
  read_errors();
  end_->killed = end_->killed || killed;
  return *end_;
}

std::string ExternalProgram::last_words() const {
  std::string_view text = words_;
  const auto blank = [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\t'; };
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  const std::size_t line = text.rfind('\n');
  if (line != std::string_view::npos) text.remove_prefix(line + 1);
  return std::string(text);
}

}  // namespace oxturn
