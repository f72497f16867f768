// Starting the programs of other packages: found in PATH, or one line that names the package.
#pragma once

#include <string>
#include <vector>

namespace regista {

/// The full path of a program. Throws CommandError naming the Debian package where it is not in PATH.
std::string find_tool(const std::string& program, const std::string& debian_package);

/// Becomes that program: same process, so that its signals, output and exit status are its own. Only returns by
/// throwing CommandError.
[[noreturn]] void become(const std::string& path, const std::vector<std::string>& arguments);

/// The folder of the running executable.
std::string own_folder();

}  // namespace regista
