// Programs started by a test, and what /proc tells of them. Whatever way a test ends, its programs end with it.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace regista {

/// The URL of a bus that is nobody else's, another one with every call: private multicast group and port, never leaving
/// the host. The processes on it can be found by it.
std::string private_bus();

/// The full path of one of our executables: "regista", "regista-sim".
std::string executable(const std::string& name);

class Program {
 public:
  /// Variables are "NAME=value" over the test's own; "NAME" alone takes one away. The input is what it reads from
  /// stdin.
  explicit Program(const std::vector<std::string>& command, const std::vector<std::string>& variables = {},
                   const std::string& input = "");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t pid() const { return pid_; }
  void send(int signal) const;

  /// Its exit status, or 128 + signal; nullopt when it does not end within a time far longer than it needs.
  std::optional<int> wait();

  std::string out() const;    ///< so far
  std::string error() const;  ///< so far

 private:
  TemporaryFolder folder_;
  pid_t pid_ = -1;
  std::optional<int> status_;
};

/// A whole run; status as of wait(), -1 when it does not end.
struct RunResult {
  int status = -1;
  std::string out;
  std::string error;
};
RunResult run(const std::vector<std::string>& command, const std::vector<std::string>& variables = {},
              const std::string& input = "");

/// Waits until it holds; false after a time far longer than a slow machine needs.
bool eventually(const std::function<bool()>& holds);

/// Living processes whose command line contains the text.
std::vector<pid_t> processes_with(const std::string& text);
bool is_alive(pid_t pid);

}  // namespace regista
