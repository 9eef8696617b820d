/// A program that is spoken to in lines on its standard input and output. Internal to bench/.
///
///   ExternalProgram program({.text = "python3 lanes.py"});
///   program.send("{\"problem\": ...}\n");
///   if (program.next_line(20) == ExternalProgram::Next::line) use(program.line());
///
/// It is started by /bin/sh -c, in the process group of the caller, and dies with it. For use in a child process under
/// limits (child_process.hpp): waiting is bounded by them alone where no time is given, and lines by kLongestLine.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

#include "bench/external_planner.hpp"
#include "bench/wire.hpp"

namespace oxturn {

/// The command in backquotes, shortened, for messages.
std::string quoted(const ShellCommand& command);
/// The beginning of a text that came from a program, in quotes and printable.
std::string beginning_of(std::string_view text);

class ExternalProgram {
 public:
  /// A path of a million points has some 40 MB.
  static constexpr std::size_t kLongestLine = std::size_t{256} << 20;

  /// Throws std::runtime_error if no process can be started. That there is no such command shows by its ending.
  explicit ExternalProgram(const ShellCommand& command);
  /// Kills it and all that it has started, as far as they are still its descendants.
  ~ExternalProgram();
  ExternalProgram(const ExternalProgram&) = delete;

  /// Is written while waiting for lines, so that a program that does not read holds up nobody.
  void send(std::string text);
  void close_input();

  enum class Next { line, closed, late, too_long };
  /// Waits for the next whole line, at most `seconds` (negative: for ever). `closed`: the output has ended, or the
  /// program; `line()` is then what came after the last line break.
  Next next_line(double seconds);
  const std::string& line() const { return line_; }
  /// Lines read so far.
  std::size_t lines() const { return lines_; }

  struct End {
    bool killed = false;  // by us, because it did not end
    int exit_code = 0, signal = 0;
  };
  /// Waits until it has ended, kills it after `seconds`; what it still prints is dropped. Its processor time is then
  /// among that of this process's children.
  End wait(double seconds);
  /// The last line that it has printed to standard error, or "". All of it is passed on to ours.
  std::string last_words() const;
  /// The most memory that it and its children have had, as far as it was seen, bytes.
  double peak_bytes() const { return peak_; }

 private:
  bool poll_all(int milliseconds);  // false if there is no output left to wait for
  void read_output();
  void read_errors();
  void write_input();
  bool take_line();
  void look_at_memory();
  bool reap();

  pid_t pid_ = -1;
  wire::Descriptor input_, output_, errors_, process_;
  std::string pending_;  // to be written
  std::size_t written_ = 0;
  std::string buffer_, line_, words_;
  std::size_t taken_ = 0, searched_ = 0;  // of buffer_; no line break before `searched_`
  std::size_t lines_ = 0;
  bool dropping_ = false;  // output is read, but not kept
  double peak_ = 0;
  std::optional<End> end_;
};

}  // namespace oxturn
