// The flag every subcommand that talks to modules has.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace regista {

inline void add_bus_flag(CLI::App& app, std::string& lcm_url) {
  app.add_option("--lcm-url", lcm_url, "LCM bus, for example udpm://239.255.76.67:7667?ttl=0")->capture_default_str();
}

}  // namespace regista
