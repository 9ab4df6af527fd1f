#include "emit/pack.hpp"

#include "emit/library.hpp"
#include "error.hpp"
#include "figure/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace fresnel::emit {

namespace {

std::string read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace

std::vector<pack_file> language_packs() {
    std::vector<pack_file> files;
    for (const language& l : languages())
        files.push_back({fmt::format("{0}/fresnel.{1}", l.id, l.extension), library_text(l)});
    return files;
}

std::vector<pack_file> all_packs() {
    std::vector<pack_file> files = language_packs();
    for (const auto pack : {materialx_pack, blender_pack})
        for (pack_file& file : pack())
            files.push_back(std::move(file));
    std::sort(files.begin(), files.end(),
              [](const pack_file& a, const pack_file& b) { return a.path < b.path; });
    return files;
}

void write_packs(const std::string& folder) {
    for (const pack_file& file : all_packs()) {
        const std::filesystem::path path = std::filesystem::path(folder) / file.path;
        std::error_code error;
        std::filesystem::create_directories(path.parent_path(), error);
        if (error)
            throw failure(
                fmt::format("{}: cannot be made: {}", path.parent_path().string(), error.message()));
        write_file(path.string(), file.text);
    }
}

std::vector<std::string> check_packs(const std::string& folder) {
    if (!std::filesystem::is_directory(folder))
        throw bad_input(fmt::format("--check '{}': is not a folder", folder));
    std::vector<std::string> differences;
    std::set<std::string> known;
    for (const pack_file& file : all_packs()) {
        const std::filesystem::path path = std::filesystem::path(folder) / file.path;
        known.insert(file.path);
        if (!std::filesystem::exists(path))
            differences.push_back(file.path + " is missing");
        else if (read(path) != file.text)
            differences.push_back(file.path + " differs");
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string path = std::filesystem::relative(entry.path(), folder).string();
        if (entry.is_regular_file() && !known.contains(path) && path != "README.md")
            differences.push_back(path + " is not generated");
    }
    return differences;
}

} // namespace fresnel::emit
