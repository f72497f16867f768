#include "modules/regista/module_process.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <utility>

#include "modules/regista/command.h"

namespace regista {
namespace {

constexpr int kCannotExecute = 127;         // as shells say it
constexpr std::size_t kLongestLine = 4096;  // a module that writes no line ends must not fill the memory
constexpr std::size_t kReadsAtOnce = 64;    // buffers: all that a pipe holds, but no more of one that talks without end

/// Holds all signals back while it lives, so that none meant for a child is taken by the launcher's handler in it.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsHeld() { release(); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  void release() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// Between fork and exec: only calls that are safe there, for LCM has threads.
[[noreturn]] void become_module(pid_t launcher, int output, char* const* argv, const SignalsHeld& signals) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != launcher) _exit(kCannotExecute);  // the launcher died before the line above
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) signal(signal_number, SIG_DFL);
  signals.release();
  close_range(STDERR_FILENO + 1, ~0U, 0);  // LCM's sockets are the launcher's
  execv(argv[0], argv);
  const char* why = std::strerror(errno);
  if (write(STDERR_FILENO, why, std::strlen(why)) > 0 && write(STDERR_FILENO, "\n", 1) > 0) _exit(kCannotExecute);
  _exit(kCannotExecute);
}

ProcessEnd describe(int status) {
  if (WIFSIGNALED(status)) return {false, "was killed by signal " + std::to_string(WTERMSIG(status))};
  return {WEXITSTATUS(status) == 0, "ended with status " + std::to_string(WEXITSTATUS(status))};
}

}  // namespace

ModuleProcess::ModuleProcess(const std::string& path, const std::vector<std::string>& arguments) {
  std::vector<char*> argv{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw CommandError(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  // The child's end must block, or its output would get lost when the launcher is slow.
  fcntl(pipe_ends[1], F_SETFL, 0);
  const pid_t launcher = getpid();
  {
    const SignalsHeld signals;
    pid_ = fork();
    if (pid_ == 0) become_module(launcher, pipe_ends[1], argv.data(), signals);
  }
  close(pipe_ends[1]);
  output_ = pipe_ends[0];
  if (pid_ < 0) {
    close(output_);
    throw CommandError("cannot start " + path + ": " + std::strerror(errno));
  }
  setpgid(pid_, pid_);  // also here: whoever comes first
}

ModuleProcess::~ModuleProcess() {
  if (!end_) {
    send(SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(output_);
}

std::vector<std::string> ModuleProcess::read_lines() {
  std::vector<std::string> lines;
  std::array<char, 4096> buffer{};
  for (std::size_t reads = 0; reads < kReadsAtOnce; ++reads) {
    const ssize_t count = read(output_, buffer.data(), buffer.size());
    if (count <= 0) break;
    for (const char c : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
      if (c != '\n' && partial_.size() < kLongestLine) {
        partial_ += c;
        continue;
      }
      lines.push_back(std::move(partial_));
      partial_.clear();
    }
  }
  if (end_ && !partial_.empty()) lines.push_back(std::exchange(partial_, {}));
  return lines;
}

const std::optional<ProcessEnd>& ModuleProcess::end() {
  int status = 0;
  if (!end_ && waitpid(pid_, &status, WNOHANG) == pid_) end_ = describe(status);
  return end_;
}

void ModuleProcess::send(int signal) const {
  if (!end_) kill(-pid_, signal);
}

}  // namespace regista
