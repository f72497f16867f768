// Parameters from a TOML scenario file and --set: defaults < file < --set < run time.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sim/scenario.h"
#include "world_model/params.h"

namespace regista {

/// A file that cannot be read or makes no sense; what() is one line that names the file and says what to do.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Config {
 public:
  /// An empty path means no file. Each setting is "section.key=value". Throws ConfigError.
  static Config load(const std::string& path, const std::vector<std::string>& settings);

  /// Sets the parameters of [section], then those of [section.yellow] or [section.blue] where a team is named.
  /// Throws ConfigError on an unknown key (naming the nearest) or a bad value.
  template <class P>
  void apply(const std::string& section, P& params, const std::string& team = {}) const {
    for (const Entry& entry : entries_of(section)) set(params, entry);
    if (team.empty()) return;
    for (const Entry& entry : entries_of(section + "." + team)) set(params, entry);
  }

  /// [scenario], validated. Throws ConfigError.
  Scenario scenario() const;

 private:
  struct Entry {
    std::string key;
    std::string text;
    std::string origin;  ///< "file.toml: " or "--set key=value: "
  };

  std::vector<Entry> entries_of(const std::string& section) const;
  void check_sections() const;

  template <class P>
  static void set(P& params, const Entry& entry) {
    try {
      set_param(params, entry.key, entry.text);
    } catch (const ParamError& error) {
      throw ConfigError(entry.origin + error.what());
    }
  }

  std::string file_;  ///< "" for none
  std::vector<Entry> entries_;
};

/// The file of a shipped scenario's name, or the name itself where it names a file. Throws ConfigError listing the
/// names.
std::string scenario_file(const std::string& name_or_path);

/// Names of the scenarios shipped beside the program, sorted.
std::vector<std::string> shipped_scenarios();

}  // namespace regista
