#include "figure_files.hpp"

#include "error.hpp"
#include "figure/leftover.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace fresnel::cli {

figure_writer writer_of(std::string_view argument, const std::string& path) {
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".svg") return [](const figure& f) { return drawn(f, format::svg); };
    if (ending == ".png") return [](const figure& f) { return drawn(f, format::png); };
    if (ending == ".pdf") return [](const figure& f) { return drawn(f, format::pdf); };
    if (ending == ".csv") return [](const figure& f) { return to_csv(f); };
    if (ending == ".json") return [](const figure& f) { return json_text(to_json(f)); };
    throw bad_input(fmt::format("{} '{}': must end in .svg, .png, .pdf, .csv or .json", argument, path));
}

void require_writable(std::string_view argument, const std::string& path) {
    if (is_folder(path)) throw bad_input(fmt::format("{} '{}': is a folder; give a file", argument, path));
    if (!staged_file(path).is_beside()) return;
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    if (access(parent.empty() ? "." : parent.c_str(), W_OK | X_OK) != 0)
        throw bad_input(
            fmt::format("{} '{}': cannot be written; give a file in a folder that can", argument, path));
}

} // namespace fresnel::cli
