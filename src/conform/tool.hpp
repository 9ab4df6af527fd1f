#pragma once

#include "figure/leftover.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace fresnel::conform {

/// A folder that disappears with its content.
class scratch_folder {
public:
    scratch_folder();
    ~scratch_folder();
    scratch_folder(const scratch_folder&) = delete;
    scratch_folder& operator=(const scratch_folder&) = delete;

    const std::filesystem::path path;

private:
    leftover removed_on_signal_;
};

/// How a program ended, and what it said on standard output and standard error together.
struct tool_end {
    int status; ///< 0 is success
    std::string said;
};

/// Runs a program found on PATH, with those arguments. Throws failure if it cannot be started.
tool_end run_tool(const std::vector<std::string>& line);

/// Whether such a program is on PATH, or is that file.
bool has_tool(const std::string& name);

std::string read_file(const std::filesystem::path& path);

} // namespace fresnel::conform
