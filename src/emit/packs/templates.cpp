#include "emit/packs/templates.hpp"

#include "error.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

constexpr std::string_view root = "src/emit/packs/templates/";

} // namespace

std::string filled(std::string_view text, const placeholders& values) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = text.find("{{", at);
        if (begin == std::string_view::npos) return result + std::string(text.substr(at));
        const std::size_t end = text.find("}}", begin);
        const std::string name(text.substr(begin + 2, end - begin - 2));
        const auto found = values.find(name);
        if (found == values.end()) throw failure(fmt::format("the template's '{}' has no value", name));
        result += std::string(text.substr(at, begin - at)) + found->second;
        at = end + 2;
    }
    return result;
}

pack_file filled_template(std::string_view path, const placeholders& values) {
    const std::string_view text = embedded_template(std::string(root) + std::string(path));
    if (text.empty()) throw failure(fmt::format("there is no template '{}'", path));
    return {std::string(path), filled(text, values)};
}

std::vector<pack_file> filled_templates(std::string_view folder, const placeholders& values) {
    std::vector<pack_file> files;
    for (const std::string_view name : embedded_template_names(std::string(root) + std::string(folder)))
        files.push_back(filled_template(name.substr(root.size()), values));
    return files;
}

placeholders common_placeholders() {
    return {{"version", FRESNEL_VERSION}, {"license", std::string(embedded_template("LICENSE"))}};
}

} // namespace fresnel::emit
