#pragma once

#include "error.hpp"
#include "figure/leftover.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace fresnel {

/// A folder for what is needed for a while: it disappears with its content, at a signal too.
class scratch_folder {
public:
    scratch_folder() : path(made()), removed_on_signal_(path.string()) {}
    ~scratch_folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    scratch_folder(const scratch_folder&) = delete;
    scratch_folder& operator=(const scratch_folder&) = delete;

    const std::filesystem::path path;

private:
    static std::filesystem::path made() {
        std::error_code error;
        std::string name = (std::filesystem::temp_directory_path(error) / "fresnel-XXXXXX").string();
        if (!error && mkdtemp(name.data()) != nullptr) return name;
        const char* wanted = std::getenv("TMPDIR");
        throw failure(std::string("TMPDIR '") + (wanted != nullptr ? wanted : "/tmp") +
                      "': is no folder for scratch files");
    }

    leftover removed_on_signal_;
};

/// Whether it is there and a folder; false too for what cannot be asked for, a name that is too long.
inline bool is_folder(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

/// All bytes of a file, nothing if it cannot be read. Tables of the user's are read by materials/table.hpp, which
/// limits their size.
inline std::optional<std::string> file_content(const std::filesystem::path& path) {
    if (is_folder(path)) return std::nullopt; // a stream opens it, then throws
    std::ifstream file(path, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(file)), {});
    if (!file) return std::nullopt;
    return content;
}

/// The same. Throws failure.
inline std::string read_file(const std::filesystem::path& path) {
    if (auto content = file_content(path)) return *std::move(content);
    throw failure(path.string() + ": cannot be read");
}

} // namespace fresnel
