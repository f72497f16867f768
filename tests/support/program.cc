#include "tests/support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace regista {
namespace {

constexpr std::chrono::seconds kPatience{90};
constexpr std::chrono::milliseconds kPoll{10};

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void redirect(int descriptor, const std::string& file, int flags) {
  dup2(open(file.c_str(), flags | O_CLOEXEC, 0600), descriptor);
}

void change_environment(const std::vector<std::string>& variables) {
  for (const std::string& variable : variables) {
    const std::size_t equals = variable.find('=');
    if (equals == std::string::npos) {
      unsetenv(variable.c_str());
    } else {
      setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
  }
}

}  // namespace

std::string private_bus() {
  // Below the ports that the system hands out (Linux: from 32768).
  constexpr int kFirstPort = 26000;
  constexpr int kPorts = 6000;
  constexpr int kStride = 997;  // prime: processes with neighbouring ids do not meet
  static int counter = 0;
  const int pid = getpid();
  return "udpm://239.255.78." + std::to_string(1 + pid % 250) + ":" +
         std::to_string(kFirstPort + (pid + kStride * counter++) % kPorts) + "?ttl=0&recv_buf_size=8388608";
}

std::string executable(const std::string& name) { return std::string(REGISTA_BIN_DIR) + "/" + name; }

Program::Program(const std::vector<std::string>& command, const std::vector<std::string>& variables,
                 const std::string& input) {
  std::ofstream(folder_.path("in"), std::ios::binary) << input;
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ > 0) return;
  redirect(STDIN_FILENO, folder_.path("in"), O_RDONLY);
  redirect(STDOUT_FILENO, folder_.path("out"), O_CREAT | O_WRONLY | O_TRUNC);
  redirect(STDERR_FILENO, folder_.path("error"), O_CREAT | O_WRONLY | O_TRUNC);
  change_environment(variables);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

Program::~Program() {
  if (status_) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void Program::send(int signal) const {
  if (!status_) kill(pid_, signal);
}

std::optional<int> Program::wait() {
  eventually([this] {
    int raw = 0;
    if (!status_ && waitpid(pid_, &raw, WNOHANG) == pid_) {
      status_ = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
    }
    return status_.has_value();
  });
  return status_;
}

std::string Program::out() const { return text_of(folder_.path("out")); }
std::string Program::error() const { return text_of(folder_.path("error")); }

RunResult run(const std::vector<std::string>& command, const std::vector<std::string>& variables,
              const std::string& input) {
  Program program(command, variables, input);
  const int status = program.wait().value_or(-1);
  return {status, program.out(), program.error()};
}

bool eventually(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(kPoll);
  }
  return true;
}

bool is_alive(pid_t pid) {
  // "pid (name) state …"; a zombie only waits for its parent.
  const std::string stat = text_of("/proc/" + std::to_string(pid) + "/stat");
  const std::size_t name_end = stat.rfind(')');
  return name_end != std::string::npos && name_end + 2 < stat.size() && stat[name_end + 2] != 'Z';
}

std::vector<pid_t> processes_with(const std::string& text) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    if (!std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; })) continue;
    std::string line = text_of(entry.path().string() + "/cmdline");
    std::replace(line.begin(), line.end(), '\0', ' ');
    const pid_t pid = std::stoi(name);
    if (line.find(text) != std::string::npos && is_alive(pid)) found.push_back(pid);
  }
  return found;
}

}  // namespace regista
