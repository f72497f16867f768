#include "modules/bench/tool.h"

#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace regista::bench {
namespace {

std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

ToolResult run_tool(const std::filesystem::path& folder, const std::vector<std::string>& words) {
  std::string line = "cd " + quoted(folder.string()) + " &&";
  for (const std::string& word : words) line += " " + quoted(word);
  FILE* pipe = popen(("{ " + line + "; } 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start a shell: " + std::string(std::strerror(errno)));
  ToolResult result;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.output.append(buffer, n);
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  return result;
}

}  // namespace regista::bench
