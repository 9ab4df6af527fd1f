// Unreal Engine: the HLSL library as an include of the material editor's Custom node.

#include "emit/library.hpp"
#include "emit/packs/templates.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

std::vector<pack_file> unreal_pack() {
    std::vector<pack_file> files = filled_templates("unreal/", common_placeholders());
    const std::string use =
        fmt::format("// Fresnel {} for Unreal Engine: name this file in Include File Paths of a "
                    "Custom node and call its functions there.\n"
                    "// Normal is PixelNormalWS, and the view is CameraVector.\n//\n",
                    FRESNEL_VERSION);
    files.push_back({"unreal/Fresnel.ush", use + library_text(find_language("hlsl"))});
    return files;
}

} // namespace fresnel::emit
