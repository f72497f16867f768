// A program started by a test, ended at the latest with it.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace regista {

class ChildProcess {
 public:
  /// program: its name among our executables. Its stderr is kept.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool running();
  void interrupt();
  /// Waits for its end. -1 where it did not end by itself.
  int exit_status();
  std::string stderr_text() const;

 private:
  pid_t pid_ = -1;
  bool ended_ = false;
  int status_ = -1;
  std::string stderr_path_;
};

}  // namespace regista
