#pragma once

#include <string>
#include <vector>

namespace fresnel {

/// How a program ended, and what it said on standard output and standard error together.
struct tool_end {
    int status; ///< 0 is success
    std::string said;
};

/// Runs a program found on PATH, with those arguments. Throws failure if it cannot be started.
tool_end run_tool(const std::vector<std::string>& line);

/// Whether such a program is on PATH, or is that file.
bool has_tool(const std::string& name);

} // namespace fresnel
