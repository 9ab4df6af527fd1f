#pragma once

#include "files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace fresnel::conform {

/// How a program ended, and what it said on standard output and standard error together.
struct tool_end {
    int status; ///< 0 is success
    std::string said;
};

/// Runs a program found on PATH, with those arguments. Throws failure if it cannot be started.
tool_end run_tool(const std::vector<std::string>& line);

/// Whether such a program is on PATH, or is that file.
bool has_tool(const std::string& name);

/// All bytes of a file. Throws failure.
std::string read_file(const std::filesystem::path& path);

} // namespace fresnel::conform
