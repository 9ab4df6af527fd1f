#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace fresnel::test {

/// A checkout of the refractiveindex.info database: the folder that FRESNEL_DATABASE names, or one called
/// refractiveindex.info/database in a folder beside this repository. Nothing where there is none.
inline std::optional<std::filesystem::path> find_database() {
    namespace fs = std::filesystem;
    if (const char* given = std::getenv("FRESNEL_DATABASE"); given != nullptr) return fs::path(given);
    std::error_code ignored;
    for (const fs::directory_entry& beside :
         fs::directory_iterator(fs::path(FRESNEL_SOURCE_DIR).parent_path(), ignored))
        for (const char* inside : {"", "data"}) {
            const fs::path candidate = beside.path() / inside / "refractiveindex.info/database";
            if (fs::exists(candidate / "catalog-nk.yml", ignored)) return candidate;
        }
    return std::nullopt;
}

} // namespace fresnel::test
