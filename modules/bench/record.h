// Under what circumstances numbers were measured; heads every CSV.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace regista::bench {

/// What all benches are told.
struct Run {
  std::filesystem::path out = "bench";  ///< folder of tables and plots, made where it is missing
  std::uint64_t seed = 1;
  std::string command;  ///< the command line, for the record
};

/// This process's own command line.
std::string own_command_line();

/// Name and value: command, seed, machine, cores, load average, compiler, flags, build type, commit ("unknown" outside
/// a checkout;
/// "-dirty" with changes), date (UTC).
using Record = std::vector<std::pair<std::string, std::string>>;
Record record_of(const Run& run);

}  // namespace regista::bench
