#include "emit/pack.hpp"

#include "emit/library.hpp"
#include "emit/packs/templates.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/leftover.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace fresnel::emit {

namespace {

/// What a reader of shaders/README.md looks for, and the folder that has it.
struct index_row {
    std::string_view folder, user, how;
};

constexpr std::array engines = {
    index_row{"unity", "Unity, built-in pipeline or URP", "into `Packages/`; materials under `Fresnel/`"},
    index_row{"unreal", "Unreal Engine",
              "`Fresnel.ush` into the shaders of a plugin; call it in a Custom node"},
    index_row{"godot", "Godot 4", "into the project; see its README"},
    index_row{"threejs", "three.js", "into the sources; see its README"},
    index_row{"blender", "Blender", "open the text in a Script node, with Open Shading Language on"},
    index_row{"materialx", "MaterialX", "add the folder to the data library's search path"},
};

// shaders/README.md, with a row for what is among the files.
pack_file index_of(const std::vector<pack_file>& files) {
    std::string rows;
    for (const index_row& e : engines)
        if (std::any_of(files.begin(), files.end(),
                        [&](const pack_file& f) { return f.path.starts_with(std::string(e.folder) + "/"); }))
            rows += fmt::format("| {} | [`{}/`]({}/) | {} |\n", e.user, e.folder, e.folder, e.how);
    for (const language& l : languages())
        rows += fmt::format("| {} | [`{}/fresnel.{}`]({}/fresnel.{}) | {} |\n", l.title, l.id, l.extension,
                            l.id, l.extension, "include it, or paste the functions that you call");
    placeholders values = common_placeholders();
    values["rows"] = rows;
    return filled_template("README.md", values);
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
    for (const auto pack : {blender_pack, godot_pack, materialx_pack, threejs_pack, unity_pack, unreal_pack})
        for (pack_file& file : pack())
            files.push_back(std::move(file));
    files.push_back(index_of(files));
    std::sort(files.begin(), files.end(),
              [](const pack_file& a, const pack_file& b) { return a.path < b.path; });
    return files;
}

void write_packs(const std::string& folder) {
    std::error_code error;
    make_folders(folder, error);
    if (error) throw failure(fmt::format("{}: cannot be made: {}", folder, error.message()));
    const staged_folder staged(folder);
    for (const pack_file& file : all_packs()) {
        const std::filesystem::path path = staged.path / file.path;
        std::filesystem::create_directories(path.parent_path());
        write_file(path.string(), file.text);
    }
    staged.finish();
}

std::vector<std::string> check_packs(const std::string& folder) {
    if (!is_folder(folder)) throw bad_input(fmt::format("--check '{}': is not a folder", folder));
    std::vector<std::string> differences;
    std::set<std::string> known;
    for (const pack_file& file : all_packs()) {
        const std::filesystem::path path = std::filesystem::path(folder) / file.path;
        known.insert(file.path);
        if (!std::filesystem::exists(path))
            differences.push_back(file.path + " is missing");
        else if (file_content(path) != file.text)
            differences.push_back(file.path + " differs");
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string path = std::filesystem::relative(entry.path(), folder).string();
        if (entry.is_regular_file() && !known.contains(path))
            differences.push_back(path + " is not generated");
    }
    return differences;
}

} // namespace fresnel::emit
