#include "tests/ssl/child_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace regista {

ChildProcess::ChildProcess(const std::string& program, const std::vector<std::string>& arguments)
    : stderr_path_("/tmp/regista-stderr-XXXXXX") {
  const int stderr_file = mkstemp(stderr_path_.data());
  if (stderr_file < 0) throw std::runtime_error("no temporary file");
  std::string path = std::string(REGISTA_BIN_DIR) + "/" + program;
  std::vector<std::string> copies = arguments;
  std::vector<char*> argv{path.data()};
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) {
    dup2(stderr_file, STDERR_FILENO);
    dup2(stderr_file, STDOUT_FILENO);
    execv(path.c_str(), argv.data());
    _exit(127);
  }
  close(stderr_file);
}

ChildProcess::~ChildProcess() {
  if (running()) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  unlink(stderr_path_.c_str());
}

bool ChildProcess::running() {
  if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
  return !ended_;
}

void ChildProcess::interrupt() { kill(pid_, SIGINT); }

int ChildProcess::exit_status() {
  if (!ended_) ended_ = waitpid(pid_, &status_, 0) == pid_;
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

std::string ChildProcess::stderr_text() const {
  std::ostringstream text;
  text << std::ifstream(stderr_path_).rdbuf();
  return text.str();
}

}  // namespace regista
