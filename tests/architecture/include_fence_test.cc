// The include fence: data flows one way and so do includes; only modules/ and logs/ see the world outside.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kFolders{"world_model", "planning", "control", "sim", "modules", "logs"};

struct Include {
  fs::path file;
  std::string target;
};

std::vector<Include> includes_of(const fs::path& folder) {
  static const std::regex line_form(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cc") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (std::regex_match(line, match, line_form)) found.push_back({entry.path(), match[1]});
    }
  }
  return found;
}

std::string first_folder(const std::string& path) { return path.substr(0, path.find('/')); }

/// Whether a file of `folder` may include `target`. Empty answer: yes; else why not.
std::string objection(const std::string& folder, const std::string& target) {
  static const std::map<std::string, std::set<std::string>> may_use{
      {"world_model", {"world_model"}},
      {"planning", {"world_model", "planning"}},
      {"control", {"world_model", "planning", "control"}},
      {"sim", {"world_model", "planning", "control", "sim"}},
      {"logs", {"world_model", "planning", "control", "sim", "logs", "modules"}},
      {"modules", {"world_model", "planning", "control", "sim", "logs", "modules"}}};
  const std::string top = first_folder(target);
  if (std::find(kFolders.begin(), kFolders.end(), top) != kFolders.end() && may_use.at(folder).count(top) == 0) {
    return "includes against the data's way";
  }
  if (folder == "modules" || folder == "logs") return "";
  static const std::regex outside(
      R"(^(lcm/|lcm$|regista/|mrpt/|thread$|mutex$|condition_variable$|future$|atomic$|fstream$|iostream$|cstdio$|)"
      R"(filesystem$|ctime$|sys/|netinet/|arpa/|unistd\.h|spdlog/|CLI/|toml\+\+/|nlohmann/|google/).*)");
  return std::regex_match(target, outside) ? "a pure core reaches outside" : "";
}

}  // namespace

TEST_CASE("includes follow the data's way and cores stay pure") {
  for (const std::string& folder : kFolders) {
    const std::vector<Include> includes = includes_of(fs::path(REGISTA_SOURCE_DIR) / folder);
    CHECK(!includes.empty());
    for (const Include& include : includes) {
      INFO(include.file.string() << " includes " << include.target);
      CHECK(objection(folder, include.target) == "");
    }
  }
}

TEST_CASE("MRPT is seen by the viewer alone, protobuf by ssl, nanoflann by one file of planning, OMPL by one folder") {
  for (const std::string& folder : kFolders) {
    for (const Include& include : includes_of(fs::path(REGISTA_SOURCE_DIR) / folder)) {
      INFO(include.file.string() << " includes " << include.target);
      const std::string file = include.file.lexically_relative(REGISTA_SOURCE_DIR).string();
      if (include.target.starts_with("mrpt/")) CHECK(file.starts_with("modules/viewer/"));
      if (include.target.starts_with("google/protobuf") || include.target.ends_with(".pb.h")) {
        CHECK(file.starts_with("modules/ssl/"));
      }
      if (include.target == "nanoflann.hpp") CHECK(file == "planning/kd_tree.h");
      if (include.target.starts_with("ompl/")) CHECK(file.starts_with("planning/planners/ompl/"));
    }
  }
}

TEST_CASE("no core reads a clock or draws from a global generator") {
  static const std::regex forbidden(
      R"((system_clock|steady_clock|high_resolution_clock|random_device|[^_a-z]rand\(\)|std::normal_distribution|std::uniform_real_distribution))");
  for (const char* folder : {"world_model", "planning", "control", "sim"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(REGISTA_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);) {
        INFO(entry.path().string() << ": " << line);
        CHECK(!std::regex_search(line, forbidden));
      }
    }
  }
}

TEST_CASE("the fence catches what it is there for") {
  CHECK(objection("planning", "control/controller.h") != "");
  CHECK(objection("world_model", "lcm/lcm-cpp.hpp") != "");
  CHECK(objection("sim", "modules/bus/bus.h") != "");
  CHECK(objection("control", "fstream") != "");
  CHECK(objection("control", "planning/plan.h") == "");
}

TEST_CASE("beside the agreed folders only the agreed files stand at the top") {
  const std::set<std::string> agreed{
      "CMakeLists.txt", "lcmtypes", "modules",   "world_model", "planning", "control", "sim",
      "logs",           "tests",    "README.md", "dev",         "LICENSE",  "build"};
  for (const auto& entry : fs::directory_iterator(REGISTA_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    INFO(name);
    CHECK((name.starts_with(".") || name.starts_with("build") || agreed.count(name) == 1));
  }
}
