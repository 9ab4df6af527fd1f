#include "emit/stages.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

bool of_dielectrics(std::string_view model) {
    for (const parameter& p : find_model<double>(model).parameters)
        if (p.name != "n_i" && p.name != "n_t" && p.name != "eta") return false;
    return true;
}

std::string value_of(program& p, const reflectance& model, const std::string& cos_i) {
    std::vector<std::string> arguments;
    for (const argument& a : model.f.arguments)
        arguments.push_back(p.use(legal_name(p.of().own(), a.name)));
    arguments.push_back(cos_i);
    return p.call(model.f.name, arguments);
}

// ---- vertex stages ------------------------------------------------------------------------------------------

enum class normals { of_vertices, of_a_map };

void place(program& p, normals n, bool textured) {
    p.begin(stage::vertex);
    const std::string position = p.made(shape::four, {p.in("position"), p.number(1)});
    p.let(shape::four, "world", p.product(p.use("model_matrix"), position));
    p.out("world_position", "world.xyz");
    p.out("world_normal", call("normalize", {p.product(p.use("normal_matrix"), p.in("normal"))}));
    if (n == normals::of_a_map) {
        const std::string tangent = p.in("tangent");
        p.let(shape::four, "along",
              p.product(p.use("model_matrix"), p.made(shape::four, {tangent + ".xyz", p.number(0)})));
        p.out("world_tangent", p.made(shape::four, {call("normalize", {"along.xyz"}), tangent + ".w"}));
    }
    if (textured) p.out("texture_position", p.in("texcoord"));
    p.clip_position(p.product(p.use("model_view_projection"), position));
}

// ---- fragment stages ----------------------------------------------------------------------------------------

void find_normal(program& p, normals n) {
    p.begin(stage::fragment);
    const std::string world_normal = p.in("world_normal");
    if (n == normals::of_vertices) {
        p.let(shape::three, "normal", call("normalize", {world_normal}));
        return;
    }
    const std::string tangent = p.in("world_tangent");
    const std::string texel = p.sample("normal_map", p.in("texture_position"));
    p.let(shape::three, "texel", fmt::format("{} * {} - {}", p.number(2), texel, p.number(1)));
    p.let(shape::three, "bitangent", fmt::format("{0}.w * cross({1}, {0}.xyz)", tangent, world_normal));
    p.let(shape::three, "normal",
          fmt::format("normalize(texel.x * {}.xyz + texel.y * bitangent + texel.z * {})", tangent,
                      world_normal));
}

void find_view(program& p) {
    const std::string place = p.in("world_position");
    p.let(shape::three, "view", fmt::format("normalize({} - {})", p.use("eye_position"), place),
          "from the surface to the eye");
}

void find_cosine(program& p) {
    p.let(shape::scalar, "cos_i", p.call("incidence_cosine", {"normal", "view"}));
}

// The lit base and the mirrored environment, by F.
void lerp_by(program& p, const std::string& F, shape type) {
    const std::string coordinate = p.in("texture_position");
    p.let(shape::three, "mirrored", p.call("reflected_direction", {"view", "normal"}));
    p.let(shape::three, "reflection", p.sample("environment", "mirrored"));
    p.let(shape::three, "base",
          fmt::format("{} * {}", p.use("base_color"), p.sample("base_map", coordinate)));
    const std::string cosine = p.call("incidence_cosine", {"normal", p.use("light_direction")});
    p.let(shape::three, "lit",
          fmt::format("base * ({} + {} * {})", p.use("ambient_color"), p.use("light_color"), cosine));
    p.color(p.made(shape::four, {p.mix("lit", "reflection", F, type), p.number(1)}));
}

// Diffuse light and highlight of one light; the highlight is F times Phong's lobe.
void light_up(program& p, const reflectance& model) {
    place(p, normals::of_vertices, false);
    find_normal(p, normals::of_vertices);
    find_view(p);
    const std::string light = p.use("light_position"), zero = p.number(0), one = p.number(1);
    p.let(shape::three, "to_light", fmt::format("{0}.xyz - {0}.w * {1}", light, p.in("world_position")));
    p.let(shape::three, "light", "normalize(to_light)");
    p.let(shape::scalar, "attenuation",
          p.choice(fmt::format("{}.w == {}", light, zero), one, fmt::format("{} / length(to_light)", one)),
          "a far light is not attenuated");
    p.let(shape::scalar, "cos_l", "dot(normal, light)");
    p.let(shape::three, "diffuse",
          fmt::format("attenuation * max(cos_l, {}) * {} * {}", zero, p.use("light_color"),
                      p.use("base_color")));
    const std::string half = p.number(0.5f);
    p.let(shape::scalar, "cos_h",
          call("sqrt", {p.limited(fmt::format("{0} + {0} * dot(light, view)", half))}),
          "of the half vector with either of them");
    p.let(model.type, "F", value_of(p, model, "cos_h"));
    const std::string mirrored = p.call("reflected_direction", {"light", "normal"});
    const std::string lobe =
        p.call("phong_lobe", {fmt::format("dot({}, view)", mirrored), p.use("shininess")});
    p.let(shape::scalar, "lobe", p.choice(fmt::format("cos_l < {}", zero), zero, lobe),
          "none where the light is behind the surface");
    p.let(shape::three, "specular", fmt::format("attenuation * lobe * F * {}", p.use("light_color")));
}

std::string lit_base(program& p) {
    return fmt::format("{} * {} + diffuse", p.use("ambient_color"), p.use("base_color"));
}

} // namespace

// ---- what every program may use -----------------------------------------------------------------------------

void declare_inputs(program& p) {
    p.uniform({"model_view_projection", shape::matrix4, "object to clip space"});
    p.uniform({"model_matrix", shape::matrix4, "object to world"});
    p.uniform({"normal_matrix", shape::matrix3, "inverse transpose of model_matrix: normals to the world"});
    p.uniform({"eye_position", shape::three, "in the world"});
    p.uniform({"light_direction", shape::three, "towards the light, unit, in the world"});
    p.uniform({"light_position", shape::four, "in the world; w = 0: the direction towards a far light"});
    p.uniform({"light_color", shape::three, ""});
    p.uniform({"ambient_color", shape::three, ""});
    p.uniform({"base_color", shape::three, "diffuse"});
    p.uniform({"shininess", shape::scalar, "of the highlight, above 0"});
    p.uniform({"opacity", shape::scalar, "of the layer seen along the normal, [0, 1]"});
    p.uniform(
        {"fresnel_opacity", shape::scalar, "its part by reflection, in [0, opacity]; 0.04 for plastic"});
    p.uniform({"table_size", shape::two, "columns and rows of fresnel_table"});
    p.uniform({"table_range", shape::two, "what the first and the last row stand for"});
    p.attribute({"position", shape::three, ""});
    p.attribute({"normal", shape::three, "unit"});
    p.attribute({"tangent", shape::four, "unit; w is the sign of the bitangent"});
    p.attribute({"texcoord", shape::two, ""});
    p.varying({"world_position", shape::three, ""});
    p.varying({"world_normal", shape::three, ""});
    p.varying({"world_tangent", shape::four, ""});
    p.varying({"texture_position", shape::two, ""});
}

void declare_textures(program& p) {
    p.uniform({"base_map", shape::map, "diffuse colour"});
    p.uniform({"normal_map", shape::map, "in tangent space, components from [-1, 1] in [0, 1]"});
    p.uniform({"environment", shape::cube, "what the surface mirrors, in the directions of the world"});
    p.uniform({"fresnel_table", shape::map, "linear filter, clamped, no mipmaps"});
}

void declare_functions(program& p) {
    const language& l = p.of().own();
    for (const function& f : record_geometry())
        p.function(f.name, print(l, f));
    for (const function& f : record_shading())
        p.function(f.name, print(l, f));
    p.function("one_minus_cos", scalar_text(l, {"one_minus_cos"}));
}

reflectance declare_model(program& p, const model_request& wanted) {
    const sole_function f = sole_text(p.of().own(), wanted, of_dielectrics(wanted.model) ? 1 : 3);
    for (const argument& a : f.arguments)
        p.uniform({legal_name(p.of().own(), a.name), a.width == 3 ? shape::three : shape::scalar, a.meaning});
    p.function(f.name, f.text);
    return {f, f.width == 3 ? shape::three : shape::scalar};
}

// ---- the techniques ---------------------------------------------------------------------------------------

void at_pixels(program& p, const reflectance& model, std::string_view how) {
    place(p, normals::of_a_map, true);
    find_normal(p, normals::of_a_map);
    find_view(p);
    shape type = model.type;
    if (how == "none") {
        p.let(type, "F", value_of(p, model, p.number(1)), "of normal incidence, at every angle");
    } else {
        find_cosine(p);
        if (how == "one-minus-cos") type = shape::scalar;
        p.let(type, "F",
              how == "one-minus-cos" ? p.call("one_minus_cos", {"cos_i"}) : value_of(p, model, "cos_i"));
    }
    lerp_by(p, "F", type);
}

void at_vertices(program& p, const reflectance& model) {
    p.varying({"reflectance", model.type, ""});
    place(p, normals::of_vertices, true);
    p.let(shape::three, "view", fmt::format("normalize({} - world.xyz)", p.use("eye_position")),
          "from the surface to the eye");
    const std::string normal = fmt::format("{}world_normal", p.of().apart ? "" : "output.");
    p.let(shape::scalar, "cos_i", p.call("incidence_cosine", {normal, "view"}));
    p.out("reflectance", value_of(p, model, "cos_i"));
    find_normal(p, normals::of_vertices);
    find_view(p);
    lerp_by(p, p.in("reflectance"), model.type);
}

void from_a_table(program& p, const std::string& rows, shape type) {
    if (!rows.empty()) p.uniform({rows, shape::scalar, rows == "f0" ? "[0, 1]" : "n_t / n_i"});
    place(p, normals::of_a_map, true);
    find_normal(p, normals::of_a_map);
    find_view(p);
    find_cosine(p);
    const std::string size = p.use("table_size"), one = p.number(1), half = p.number(0.5f);
    p.note("cos_i = 0 and 1 are the centres of the first and the last texel");
    p.let(shape::scalar, "column", fmt::format("(cos_i * ({0}.x - {1}) + {2}) / {0}.x", size, one, half));
    std::string row = half;
    if (!rows.empty()) {
        const std::string range = p.use("table_range");
        row = p.let(shape::scalar, "row",
                    fmt::format("(({0} - {1}.x) / ({1}.y - {1}.x) * ({2}.y - {3}) + {4}) / {2}.y",
                                p.use(rows), range, size, one, half));
    }
    p.let(type, "F", p.sample("fresnel_table", p.made(shape::two, {"column", row}), type));
    lerp_by(p, "F", type);
}

void highlights(program& p, const reflectance& model) {
    light_up(p, model);
    p.color(p.made(shape::four, {lit_base(p) + " + specular", p.number(1)}));
}

void semitransparent(program& p, const reflectance& model) {
    light_up(p, model);
    find_cosine(p);
    const std::string opacity = p.use("opacity"), part = p.use("fresnel_opacity");
    const std::string along = p.call("opacity_attenuation", {opacity, part});
    p.let(shape::scalar, "alpha_F", p.call("opacity_fresnel", {part, "cos_i"}));
    p.let(shape::scalar, "alpha_att",
          p.call("opacity_silhouette", {fmt::format("max({}, {})", along, p.number(0)), "cos_i"}));
    p.let(shape::scalar, "alpha", p.call("opacity_total", {"alpha_att", "alpha_F"}));
    p.note("the highlight is not weakened by the opacity, the diffuse light by its attenuation alone");
    p.color(p.made(shape::four, {fmt::format("alpha_att * ({}) + specular", lit_base(p)), "alpha"}));
}

} // namespace fresnel::emit
