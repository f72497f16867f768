// A program started by a test, with its own end on any way out of the test.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace regista {

class ChildProcess {
 public:
  /// Standard output and error go to the file `output`. `environment` are "NAME=value" over the test's own; "NAME"
  /// alone takes the variable away.
  ChildProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment,
               const std::string& output);
  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  void signal(int number) const;
  bool running();

  /// Exit status, 128 + signal where one ended it; nullopt when it runs on after that time.
  std::optional<int> wait(std::chrono::milliseconds at_most);

 private:
  int pid_ = -1;
  std::optional<int> status_;
};

/// A whole run: exit status (or -1 after half a minute) and all output.
struct RunResult {
  int status = -1;
  std::string output;
};
RunResult run(const std::vector<std::string>& command, const std::vector<std::string>& environment = {});

std::string text_of(const std::string& file);

}  // namespace regista
