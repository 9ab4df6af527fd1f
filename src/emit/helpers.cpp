// The functions that surround the models in every library.

#include "emit/function.hpp"

#include <fresnel/geometry.hpp>
#include <fresnel/shading.hpp>

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

// A function that is not of the registry: its arguments are declared, then `body` makes its value of them.
template <class Body>
function record_helper(std::string_view name, std::vector<argument> arguments,
                       std::vector<std::string> comment, Body&& body) {
    function f;
    f.name = name;
    f.arguments = std::move(arguments);
    f.directions = true;
    const recording scope(f.graph);
    std::vector<sym> values;
    for (const argument& a : f.arguments)
        if (a.width == 2)
            for (const char* part : {".x", ".y"})
                values.push_back(f.graph.input(a.name + part));
        else
            values.push_back(f.graph.input(a.name, a.width));
    f.graph.set_own(name);
    for (const std::uint32_t node : nodes_of(body(values)))
        f.results.push_back({std::string(name), node});
    simplify(f);
    f.comment = std::move(comment);
    if (!f.arguments.front().meaning.empty()) f.comment.emplace_back();
    for (const argument& a : f.arguments)
        if (!a.meaning.empty()) f.comment.push_back(fmt::format("{:<9} {}", a.name, a.meaning));
    return f;
}

} // namespace

std::vector<function> record_geometry() {
    using values = const std::vector<sym>&;
    const argument v{"direction", 3,
                     "where the light comes from, or the eye is; unit, on the side of normal"};
    const argument n{"normal", 3, "unit"};
    const argument eta{"eta", 1, "n_t / n_i, above 0"};
    const argument cos_i{"cos_i", 1, std::string(angle_meaning)};
    std::vector<function> all;
    all.push_back(record_helper("incidence_cosine", {n, v},
                                {"The cosine between two directions, 0 where they lie on opposite sides."},
                                [](values x) { return fresnel::incidence_cosine(x[0], x[1]); }));
    all.push_back(record_helper("reflected_direction", {v, n},
                                {"The mirror direction, on the side of normal.", "", "  r = 2 (n . v) n - v"},
                                [](values x) { return fresnel::reflect(x[0], x[1]); }));
    all.push_back(
        record_helper("refracted_direction", {v, n, eta},
                      {"The refracted direction, on the other side of normal; the zero vector beyond the "
                       "critical angle.",
                       "", "  t = -(v - cos_i n) / eta - cos_t n"},
                      [](values x) { return fresnel::refract(x[0], x[1], x[2]); }));
    all.push_back(record_helper("refracted_cosine", {eta, cos_i},
                                {"Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.",
                                 "", "  cos_t = sqrt(eta^2 - 1 + cos_i^2) / eta"},
                                [](values x) { return fresnel::refracted_cosine(x[0], x[1]); }));
    all.push_back(
        record_helper("critical_cosine", {eta},
                      {"Cosine of the critical angle, beyond which everything is reflected; 0 where there "
                       "is none.",
                       "", "  cos_c = sqrt(1 - eta^2)"},
                      [](values x) { return fresnel::critical_cosine(x[0]); }));
    all.push_back(record_helper("brewster_cosine", {eta},
                                {"Cosine of Brewster's angle, at which p-polarised light is not reflected.",
                                 "", "  cos_B = 1 / sqrt(1 + eta^2)"},
                                [](values x) { return fresnel::brewster_cosine(x[0]); }));
    all.push_back(record_helper("f0_from_eta", {eta},
                                {"Reflectance at normal incidence.", "", "  f0 = ((eta - 1) / (eta + 1))^2"},
                                [](values x) { return fresnel::f0_from_eta(x[0]); }));
    all.push_back(record_helper("eta_from_f0", {{"f0", 1, "reflectance at normal incidence, [0, 1)"}},
                                {"The relative index above 1 that has this f0.", "",
                                 "  eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)"},
                                [](values x) { return fresnel::eta_from_f0(x[0]); }));
    return all;
}

std::vector<function> record_shading() {
    using values = const std::vector<sym>&;
    const argument cos_i{"cos_i", 1, "cosine between view and normal, [0, 1]"};
    const argument part{"fresnel", 1, "opacity by reflection, [0, 1]"};
    std::vector<function> all;
    all.push_back(record_helper("phong_lobe",
                                {{"cos_r", 1, "cosine between the view and the mirrored light, [-1, 1]"},
                                 {"shininess", 1, "sharpness, above 0"}},
                                {"The lobe of Phong's highlight, to be multiplied by the reflectance.", "",
                                 "  max(cos_r, 0)^shininess"},
                                [](values x) { return fresnel::phong_lobe(x[0], x[1]); }));
    all.push_back(record_helper("opacity_fresnel",
                                {{"a0", 1, "opacity by reflection seen along the normal, [0, 1]"}, cos_i},
                                {"Opacity by reflection: from the user's value to 1 at the silhouette.", "",
                                 "  a0 + (1 - a0) (1 - cos_i)^5"},
                                [](values x) { return fresnel::opacity_fresnel(x[0], x[1]); }));
    all.push_back(record_helper(
        "opacity_silhouette", {{"a", 1, "opacity by attenuation seen along the normal, [0, 1]"}, cos_i},
        {"Opacity by attenuation in a thin layer, in proportion to the path through it.", "",
         "  min(1, a / cos_i)"},
        [](values x) { return fresnel::opacity_silhouette(x[0], x[1]); }));
    all.push_back(record_helper(
        "opacity_attenuation",
        {{"total", 1, "opacity of the whole, [0, 1]"}, {"fresnel", 1, "opacity by reflection, [0, 1)"}},
        {"The opacity by attenuation that gives a layer a total opacity; negative "
         "where there is none.",
         "", "  (total - fresnel) / (1 - fresnel)"},
        [](values x) { return fresnel::opacity_attenuation(x[0], x[1]); }));
    all.push_back(record_helper(
        "opacity_total", {{"attenuation", 1, "opacity by attenuation, [0, 1]"}, part},
        {"Opacity of a layer that attenuates and reflects.", "", "  1 - (1 - attenuation) (1 - fresnel)"},
        [](values x) { return fresnel::opacity_total(x[0], x[1]); }));
    return all;
}

std::vector<function> record_twofold() {
    using values = const std::vector<sym>&;
    using twofold = fresnel::twofold<sym>;
    const argument a{"a", 1, ""}, b{"b", 1, ""}, a2{"a", 2, ""}, b2{"b", 2, ""};
    std::vector<function> all;
    all.push_back(
        record_helper("two_sum", {a, b},
                      {"a + b without rounding error: x is the rounded sum, y what it lacks (Knuth 1969).",
                       "Right only where the compiler does not rearrange: no fast math, precise where the "
                       "language has it."},
                      [](values x) { return two_sum(x[0], x[1]); }));
    all.push_back(record_helper(
        "halves", {a},
        {"a = x + y, half of its digits in each, so that products of halves are exact (Veltkamp 1968)."},
        [](values x) { return fresnel::halves(x[0]); }));
    all.push_back(record_helper(
        "two_product", {a, b},
        {"a b without rounding error: x is the rounded product, y what it lacks (Dekker 1971)."},
        [](values x) { return two_product(x[0], x[1]); }));
    all.push_back(record_helper("twofold_sum", {a2, b2},
                                {"a + b, where each number is a sum x + y with twice the digits of a float."},
                                [](values x) { return twofold{x[0], x[1]} + twofold{x[2], x[3]}; }));
    all.push_back(record_helper("twofold_difference", {a2, b2}, {"a - b of such numbers."},
                                [](values x) { return twofold{x[0], x[1]} - twofold{x[2], x[3]}; }));
    all.push_back(record_helper("twofold_product", {a2, b2}, {"a b of such numbers."},
                                [](values x) { return twofold{x[0], x[1]} * twofold{x[2], x[3]}; }));
    return all;
}

} // namespace fresnel::emit
