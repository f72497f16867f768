#include "tests/ssl/protoc.h"

#include <stdexcept>

#include "tests/support/program.h"

namespace regista {
namespace {

/// What the command writes when it reads the input.
std::string filter(const std::vector<std::string>& command, const std::string& input) {
  const RunResult result = run(command, {}, input);
  if (result.status != 0) throw std::runtime_error("protoc failed on: " + input + "\n" + result.error);
  return result.out;
}

std::vector<std::string> protoc(const std::string& action, const std::string& proto_file) {
  const std::string folder = std::string(REGISTA_SOURCE_DIR) + "/modules/ssl/proto";
  return {"protoc", action, "-I", folder, folder + "/" + proto_file};
}

}  // namespace

std::string protoc_encode(const std::string& proto_file, const std::string& type, const std::string& text) {
  return filter(protoc("--encode=" + type, proto_file), text);
}

std::string protoc_decode(const std::string& proto_file, const std::string& type, const std::string& bytes) {
  return filter(protoc("--decode=" + type, proto_file), bytes);
}

std::string protoc_decode_raw(const std::string& bytes) { return filter({"protoc", "--decode_raw"}, bytes); }

}  // namespace regista
