// Unity: a package of the Package Manager. Its shaders are templates; the library that they include is generated.

#include "emit/library.hpp"
#include "emit/packs/templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fresnel::emit {

namespace {

constexpr std::string_view folder = "unity/";

std::uint64_t fnv1a(std::string_view text, std::uint64_t hash) {
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

// Unity knows an asset by 32 hexadecimal digits. They are made from its path in the package, so that they never change.
std::string identifier(std::string_view path) {
    const std::string named = "com.fresnel.shaders/" + std::string(path);
    return fmt::format("{:016x}{:016x}", fnv1a(named, 0xcbf29ce484222325u),
                       fnv1a(named, 0x6c62272e07bb0142u));
}

std::string importer_of(std::string_view path) {
    if (path == "package.json") return "PackageManifestImporter";
    if (path.ends_with(".shader")) return "ShaderImporter";
    if (path.ends_with(".hlsl")) return "ShaderIncludeImporter";
    return "TextScriptImporter";
}

pack_file meta(const std::string& path, bool is_folder) {
    const std::string head = fmt::format("fileFormatVersion: 2\nguid: {}\n", identifier(path)) +
                             (is_folder ? "folderAsset: yes\nDefaultImporter:\n" : importer_of(path) + ":\n");
    return {fmt::format("{}{}.meta", folder, path),
            head + "  externalObjects: {}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n"};
}

// A .meta for each file and each folder: without one, an asset of a package is ignored.
void add_meta(std::vector<pack_file>& files) {
    std::set<std::string> folders;
    const std::size_t count = files.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::string path = files[i].path.substr(folder.size());
        files.push_back(meta(path, false));
        for (std::size_t slash = path.find('/'); slash != std::string::npos;
             slash = path.find('/', slash + 1))
            folders.insert(path.substr(0, slash));
    }
    for (const std::string& path : folders)
        files.push_back(meta(path, true));
}

} // namespace

std::vector<pack_file> unity_pack() {
    const placeholders values = common_placeholders();
    std::vector<pack_file> files = filled_templates(folder, values);
    files.push_back({fmt::format("{}LICENSE.md", folder), values.at("license")});
    files.push_back(
        {fmt::format("{}Runtime/Shaders/Fresnel.hlsl", folder), library_text(find_language("hlsl"))});
    add_meta(files);
    return files;
}

} // namespace fresnel::emit
