#include "tests/ssl/protoc.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace regista {
namespace {

/// What the command writes when it reads the input.
std::string filter(const std::string& command, const std::string& input) {
  std::string path = "/tmp/regista-protoc-XXXXXX";
  const int descriptor = mkstemp(path.data());
  if (descriptor < 0) throw std::runtime_error("no temporary file");
  close(descriptor);
  std::ofstream(path, std::ios::binary) << input;
  FILE* pipe = popen((command + " < " + path + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + command);
  std::string output;
  std::array<char, 4096> chunk{};
  std::size_t size = 0;
  while ((size = fread(chunk.data(), 1, chunk.size(), pipe)) > 0) output.append(chunk.data(), size);
  const int status = pclose(pipe);
  unlink(path.c_str());
  if (status != 0) throw std::runtime_error(command + " failed on: " + input);
  return output;
}

std::string protoc(const std::string& action, const std::string& proto_file) {
  const std::string folder = std::string(REGISTA_SOURCE_DIR) + "/modules/ssl/proto";
  return "protoc " + action + " -I " + folder + " " + folder + "/" + proto_file;
}

}  // namespace

std::string protoc_encode(const std::string& proto_file, const std::string& type, const std::string& text) {
  return filter(protoc("--encode=" + type, proto_file), text);
}

std::string protoc_decode(const std::string& proto_file, const std::string& type, const std::string& bytes) {
  return filter(protoc("--decode=" + type, proto_file), bytes);
}

std::string protoc_decode_raw(const std::string& bytes) { return filter("protoc --decode_raw", bytes); }

}  // namespace regista
