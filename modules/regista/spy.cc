#include "modules/regista/spy.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "modules/process/module_program.h"
#include "modules/regista/bus_flag.h"
#include "modules/regista/external_tool.h"

namespace regista {
namespace {

constexpr const char* kLcmJar = "/usr/share/java/lcm.jar";
constexpr const char* kChartJar = "/usr/share/java/jchart2d.jar";

void require_file(const std::string& file, const std::string& cure) {
  if (!std::filesystem::is_regular_file(file)) throw CommandError("no " + file + ": " + cure);
}

int spy(const std::string& lcm_url) {
  const std::string java = find_tool("java", "default-jre");
  const std::string types =
      (std::filesystem::path(own_folder()).parent_path() / "regista_types.jar").lexically_normal().string();
  require_file(kLcmJar, "install it with 'apt-get install liblcm-java'");
  require_file(kChartJar, "install it with 'apt-get install libjchart2d-java'");
  require_file(types, "install default-jdk-headless and build again");
  if (std::getenv("DISPLAY") == nullptr) throw CommandError("no display for lcm-spy: set DISPLAY");
  setenv("LCM_DEFAULT_URL", lcm_url.c_str(), 1);
  // Debian's own lcm-spy passes a flag that Java 9 and later refuse, hence not that one.
  become(java, {"-Djava.net.preferIPv4Stack=true", "-Xmx128m", "-ea", "-cp",
                std::string(kLcmJar) + ":" + kChartJar + ":" + types, "lcm.spy.Spy"});
}

}  // namespace

void add_spy(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("spy", "watch the channels in lcm-spy");
  const auto lcm_url = std::make_shared<std::string>(default_lcm_url());
  add_bus_flag(*command, *lcm_url);
  command->callback([lcm_url, &action] { action = [lcm_url] { return spy(*lcm_url); }; });
}

}  // namespace regista
