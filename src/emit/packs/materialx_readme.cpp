#include "analysis/curve.hpp"
#include "emit/packs/materialx.hpp"
#include "figure/figure.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

const normal_colour& copper() {
    static const normal_colour colour = colour_at_normal(load_material("copper"), color_space::srgb, 1);
    return colour;
}

std::string triple(const rgb& c, int digits) {
    return fmt::format("{1:.{0}g}, {2:.{0}g}, {3:.{0}g}", digits, c[0], c[1], c[2]);
}

} // namespace

std::vector<function> materialx_functions() {
    std::vector<function> found;
    for (const function& f : record_geometry())
        if (std::all_of(f.arguments.begin(), f.arguments.end(),
                        [](const argument& a) { return a.width == 1; }))
            found.push_back(f);
    return found;
}

std::string materialx_example() {
    return fmt::format(R"(<?xml version="1.0"?>
<materialx version="1.39" colorspace="lin_rec709">
  <!-- The reflectance of copper as a colour that depends on the angle, shown unlit.
       n and k: {0} -->
  <fresnel_f82_tint name="reflectance" type="color3">
    <input name="f0" type="color3" value="{1}" />
    <input name="tint" type="color3" value="{2}" />
  </fresnel_f82_tint>
  <surface_unlit name="shader" type="surfaceshader">
    <input name="emission_color" type="color3" nodename="reflectance" />
  </surface_unlit>
  <surfacematerial name="copper" type="material">
    <input name="surfaceshader" type="surfaceshader" nodename="shader" />
  </surfacematerial>
</materialx>
)",
                       markup_text(copper().page), triple(copper().f0, 4), triple(copper().f82_tint, 4));
}

std::string materialx_readme() {
    std::string text = fmt::format("# Fresnel nodes for MaterialX, version {}\n", FRESNEL_VERSION);
    text += R"(
A data library for MaterialX 1.39: a node for every Fresnel model of `fresnel`, for numbers (`float`) and for colours
(`color3`, whose channels share the angle), with source text in GLSL and in OSL. MaterialX's GLSL, ESSL, Vulkan, WGSL,
MSL and Slang targets all use the GLSL text. There is none for MDL.

## Use

Copy `libraries/fresnel` into the `libraries` folder of MaterialX, or add the folder that holds `libraries` to
`MATERIALX_SEARCH_PATH`. Then use the nodes as any other, as in `examples/copper.mtlx`:

    <fresnel_f82_tint name="reflectance" type="color3">
      <input name="f0" type="color3" value=")" +
            triple(copper().f0, 2) + R"(" />
    </fresnel_f82_tint>

- `fresnel_MODEL` takes `normal` and `viewdirection`, which are the shaded point's own where nothing is connected.
  `viewdirection` points from the eye to the surface, as everywhere in MaterialX.
- `fresnel_MODEL_cos` takes `cos_i`, the cosine of incidence, from `fresnel_cosine` or from you.
- `fresnel_MODEL_boundary`, of the exact models, has four outputs: reflectance and transmittance of both polarisations.
- Seen from behind, the cosine is 0. From inside a transparent medium swap `n_i` and `n_t`.

Indices of colour nodes are colours, as in MaterialX's own `conductor_bsdf`. Inputs are not clamped: the ranges are those
of the sliders, and outside them the models are not defined.

## Nodes

| node | inputs | what it is | equation |
|---|---|---|---|
)";
    for (const model_row<double>& row : model_table<double>()) {
        std::vector<std::string_view> names;
        for (const parameter& p : row.parameters)
            names.push_back(p.name);
        std::string equation(row.equation);
        for (std::size_t at = 0; (at = equation.find('|', at)) != std::string::npos; at += 2)
            equation.insert(at, 1, '\\');
        text += fmt::format("| `fresnel_{}` | {} | {} | {} |\n", row.name, fmt::join(names, ", "),
                            row.summary, equation);
    }
    for (const function& f : materialx_functions())
        text += fmt::format("| `fresnel_{}` | {} | {} | {} |\n", f.name, f.arguments.front().name,
                            f.comment.front(), f.comment.size() > 2 ? f.comment[2].substr(2) : "");
    return text;
}

} // namespace fresnel::emit
