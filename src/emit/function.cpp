#include "emit/function.hpp"

#include "analysis/prove.hpp"
#include "error.hpp"

#include <fresnel/geometry.hpp>
#include <fresnel/shading.hpp>

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

// ---- recording --------------------------------------------------------------------------------------------

std::string meaning_of(const parameter& p) { return fmt::format("{}, [{}, {}]", p.meaning, p.min, p.max); }

constexpr std::string_view angle_meaning = "cosine of incidence, [0, 1]";

void check_fixed(const model_row<double>& row, const request& wanted) {
    for (const auto& [name, values] : wanted.fixed) {
        const parameter* found = nullptr;
        std::vector<std::string> names;
        for (const parameter& p : row.parameters) {
            names.emplace_back(p.name);
            if (p.name == name) found = &p;
        }
        if (found == nullptr)
            throw bad_input(fmt::format(
                "parameter '{}' is none of {}{}: it takes {}", name, row.name, did_you_mean(name, names),
                names.empty() ? "no parameters" : fmt::format("{}", fmt::join(names, ", "))));
        for (const float value : values)
            check_range(*found, static_cast<double>(value));
    }
}

sym symbol_of(function& f, const parameter& p, const request& wanted) {
    if (const auto found = wanted.fixed.find(std::string(p.name)); found != wanted.fixed.end()) {
        const auto& [r, g, b] = found->second;
        if (r == g && g == b) return sym::constant(r);
        const sym value = sym::constant(found->second);
        f.graph.name(value.node(), p.name);
        return value;
    }
    const int width = is_ambient(p) ? 1 : wanted.width;
    f.arguments.push_back({std::string(p.name), width, meaning_of(p)});
    return f.graph.input(p.name, width);
}

// An equation on lines of its own, broken after commas where it is long.
void add_equation(std::vector<std::string>& lines, std::string_view equation) {
    constexpr std::size_t longest = 96;
    std::string line = equation.find('=') < equation.find(',') ? "  " : "  F = ";
    while (!equation.empty()) {
        const std::size_t end = std::min(equation.find(", "), equation.size());
        const std::string_view part = equation.substr(0, std::min(end + 2, equation.size()));
        if (line.size() + part.size() > longest)
            lines.push_back(line.substr(0, line.size() - 1)), line = "  ";
        line += part;
        equation.remove_prefix(part.size());
    }
    lines.push_back(line);
}

std::string error_of(const model_row<double>& row) {
    if (!row.error.in_float32.empty()) return fmt::format("rounding only, in float {}", row.error.in_float32);
    return fmt::format("at most {:.3g}, {}: {}", row.error.max,
                       can_prove(row.error.over) ? "certified" : "measured", row.error.over);
}

std::vector<std::string> comment_of(const model_row<double>& row, const function& f) {
    std::vector<std::string> lines = {std::string(row.summary), ""};
    add_equation(lines, row.equation);
    lines.emplace_back();
    for (const argument& a : f.arguments)
        lines.push_back(fmt::format("{:<7} {}", a.name, a.meaning));
    lines.push_back(fmt::format("error   {}", error_of(row)));
    lines.push_back(fmt::format("cost    {} operations", count_operations(f).cost()));
    lines.push_back(fmt::format("source  {}", row.citation));
    return lines;
}

// Three of the three: a constant result still has the width that was asked for.
sym widened(sym x, int width) {
    return recording::graph()[x.node()].width == width ? x : x * sym::constant(std::array<float, 3>{1, 1, 1});
}

void record_row(const model_row<sym>& row, function& f, const request& wanted) {
    std::vector<sym> values;
    for (const parameter& p : row.parameters)
        values.push_back(symbol_of(f, p, wanted));
    f.arguments.push_back({"cos_i", 1, std::string(angle_meaning)});
    const sym cos_i = f.graph.input("cos_i");
    if (wanted.boundary && row.polarised()) {
        const boundary<sym> b = row.evaluate(values.data(), cos_i);
        f.results = {
            {"R_s", b.R_s.node()}, {"R_p", b.R_p.node()}, {"T_s", b.T_s.node()}, {"T_p", b.T_p.node()}};
        return;
    }
    bool rgb = wanted.width == 3 && row.name != "one_minus_cos";
    for (const auto& [name, fixed] : wanted.fixed)
        rgb = rgb || fixed[0] != fixed[1] || fixed[1] != fixed[2];
    const sym R = reflectance(row, values, cos_i);
    f.results = {{"R", rgb ? widened(R, 3).node() : R.node()}};
}

} // namespace

function scalarized(const function& f, std::string (*component)(std::string_view name, int i)) {
    function split;
    split.name = f.name, split.arguments = f.arguments, split.comment = f.comment;
    split.directions = f.directions, split.components = f.width() == 3;
    const recording scope(split.graph);
    const std::vector<bool> needed = needed_nodes(f);
    std::vector<std::array<std::uint32_t, 3>> now(f.graph.size());
    for (std::uint32_t i = 0; i < f.graph.size(); ++i) {
        if (!needed[i]) continue;
        const expression& x = f.graph[i];
        for (std::size_t c = 0; c < 3; ++c) {
            if (c > 0 && x.width == 1) {
                now[i][c] = now[i][0];
            } else if (x.op == operation::input) {
                const std::string name = x.width == 3 ? component(x.name, static_cast<int>(c)) : x.name;
                now[i][c] = split.graph.input(name).node();
            } else if (x.op == operation::constant) {
                now[i][c] = sym::constant(x.value[c]).node();
            } else if (x.op == operation::dot_product) {
                const auto &a = now[x.operands[0]], &b = now[x.operands[1]];
                now[i][c] = (sym(a[0]) * sym(b[0]) + sym(a[1]) * sym(b[1]) + sym(a[2]) * sym(b[2])).node();
            } else {
                std::array<std::uint32_t, 3> operands{};
                for (std::size_t k = 0; k < arity(x.op); ++k)
                    operands[k] = now[x.operands[k]][c];
                now[i][c] = split.graph.make(x.op, operands);
            }
            if (x.named != 0 && (c == 0 || x.width == 3))
                split.graph.name(now[i][c],
                                 x.width == 3 ? x.name + "_" + (f.directions ? "xyz" : "rgb")[c] : x.name);
        }
    }
    for (const result& r : f.results)
        for (std::size_t c = 0; c < (split.components ? 3u : 1u); ++c)
            split.results.push_back({r.name, now[r.node][c]});
    return split;
}

function record(std::string_view model, const request& wanted) {
    const model_row<double>& row = find_model<double>(model);
    check_fixed(row, wanted);
    function f;
    f.name = row.name;
    const recording scope(f.graph);
    record_row(find_model<sym>(model), f, wanted);
    simplify(f);
    f.comment = comment_of(row, f);
    return f;
}

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
        values.push_back(f.graph.input(a.name, a.width));
    f.results = {{std::string(name), body(values).node()}};
    simplify(f);
    f.comment = std::move(comment);
    f.comment.emplace_back();
    for (const argument& a : f.arguments)
        f.comment.push_back(fmt::format("{:<9} {}", a.name, a.meaning));
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

} // namespace fresnel::emit
