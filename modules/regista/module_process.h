// One child process, watched: what it writes, whether it lives, how it ended. It cannot outlive its launcher, even one
// that is killed outright.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace regista {

struct ProcessEnd {
  bool in_order = false;  ///< exit status 0
  std::string text;       ///< "ended with status 1" or "was killed by signal 9"
};

class ModuleProcess {
 public:
  /// Starts the program in a process group of its own, so that the terminal's Ctrl-C reaches the launcher alone. Its
  /// output goes to read_lines(). Throws CommandError when no process can be made; a program that cannot be executed
  /// ends at once and says why.
  ModuleProcess(const std::string& path, const std::vector<std::string>& arguments);

  /// Kills it where it still lives.
  ~ModuleProcess();
  ModuleProcess(const ModuleProcess&) = delete;
  ModuleProcess& operator=(const ModuleProcess&) = delete;

  pid_t pid() const { return pid_; }

  /// Whole lines it has written to stdout and stderr since the last call; after its end the rest as well. Never waits.
  std::vector<std::string> read_lines();

  /// Nothing while it lives. Never waits.
  const std::optional<ProcessEnd>& end();

  /// To it and its own children; of no effect after its end.
  void send(int signal) const;

 private:
  pid_t pid_ = -1;
  int output_ = -1;  ///< read end of its output
  std::string partial_;
  std::optional<ProcessEnd> end_;
};

}  // namespace regista
