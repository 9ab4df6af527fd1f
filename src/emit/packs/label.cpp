#include "emit/packs/label.hpp"

#include <cctype>

namespace fresnel::emit {

std::string parameter_label(std::string_view name) {
    if (name == "n_i") return "IOR in front";
    if (name == "n_t") return "IOR behind";
    if (name == "k_t") return "Extinction";
    if (name == "n") return "IOR";
    if (name == "k") return "Extinction";
    if (name == "eta") return "Relative IOR";
    if (name == "f0") return "F0";
    if (name == "f82") return "F82";
    if (name == "f90") return "F90";
    if (name == "r") return "Reflectivity";
    if (name == "g") return "Edge Tint";
    std::string text(name);
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

} // namespace fresnel::emit
