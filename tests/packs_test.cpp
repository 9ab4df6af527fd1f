// The packs for engines: the files that each installs, and what their compilers say of them.

#include "command.hpp"
#include "shader_compilers.hpp"
#include "shader_lab.hpp"

#include "emit/pack.hpp"
#include "render/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace fresnel::test {

namespace {

const std::string stubs = std::string(FRESNEL_SOURCE_DIR) + "/tests/unity";
const std::string templates = std::string(FRESNEL_SOURCE_DIR) + "/src/emit/packs/templates/";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const emit::pack_file& file_of(const std::vector<emit::pack_file>& files, std::string_view path) {
    const auto found =
        std::find_if(files.begin(), files.end(), [&](const emit::pack_file& f) { return f.path == path; });
    if (found == files.end()) throw std::runtime_error(fmt::format("no file {}", path));
    return *found;
}

std::vector<emit::pack_file> shaders() {
    std::vector<emit::pack_file> found;
    for (const emit::pack_file& f : emit::unity_pack())
        if (f.path.ends_with(".shader")) found.push_back(f);
    return found;
}

/// Compiles HLSL in a folder that holds the Unity pack.
class packs : public shader_test {
protected:
    void write_pack(const std::vector<emit::pack_file>& files) const {
        for (const emit::pack_file& f : files)
            write(f.path, f.text);
    }
    // The messages for both stages of a program that stands in the folder.
    std::string compiled(const std::string& path, const std::string& vertex,
                         const std::string& fragment) const {
        return complaints(fmt::format("glslangValidator -D -V -S vert -e {0} '-I{2}' -o v.spv '{1}'", vertex,
                                      path, stubs)) +
               complaints(fmt::format("glslangValidator -D -V -S frag -e {0} '-I{2}' -o f.spv '{1}'",
                                      fragment, path, stubs));
    }
};

std::string with_pass(const std::string& from, const std::string& to) {
    return replaced(file_of(emit::unity_pack(), "unity/Runtime/Shaders/BuiltIn/Lit.shader").text, from, to);
}

std::string first_complaint(const std::string& shader) {
    const shader_lab read(shader);
    return read.complaints.empty() ? "" : read.complaints.front();
}

} // namespace

// ---- Unity --------------------------------------------------------------------------------------------------

TEST_F(packs, unity_shaders_are_ShaderLab) {
    std::set<std::string> names;
    for (const emit::pack_file& f : shaders()) {
        const shader_lab shader(f.text);
        EXPECT_TRUE(shader.complaints.empty()) << f.path << ": " << shader.complaints.front();
        EXPECT_TRUE(names.insert(shader.name).second) << shader.name;
        const bool universal = f.path.find("/Universal/") != std::string::npos;
        EXPECT_EQ(shader.name.rfind("Fresnel/Universal/", 0) == 0, universal) << f.path;
        EXPECT_EQ(f.text.find("Blend One One\n") != std::string::npos,
                  !universal && std::regex_search(f.path, std::regex("(Lit|Highlights|Semitransparent)\\.")))
            << f.path;
    }
    EXPECT_EQ(names.size(), 14u);
}

TEST_F(packs, ShaderLab_that_is_broken_is_refused) {
    EXPECT_EQ(first_complaint(with_pass("Diffuse", "Diffuse")), "");
    EXPECT_EQ(first_complaint(with_pass("Blend One One", "Bled One One")), "line 55: Pass has no 'Bled'");
    EXPECT_EQ(first_complaint(with_pass("Blend One One", "Blend One Two")),
              "line 55: 'Two' is none of the words known here");
    EXPECT_EQ(first_complaint(with_pass("    FallBack \"Diffuse\"\n}\n", "")),
              "line 74: '' where '}' must stand");
    EXPECT_EQ(first_complaint(with_pass("= (1, 1, 1, 1)", "= (1, 1, 1)")),
              "line 7: ')' where ',' must stand");
    EXPECT_EQ(first_complaint(with_pass("Range(0.1, 20)", "Rang(0.1, 20)")),
              "line 10: 'Rang' is none of the words known here");
    EXPECT_NE(first_complaint(with_pass("ENDCG\n        }\n\n", "}\n\n")), "");
    EXPECT_EQ(first_complaint(with_pass("#pragma fragment surface_fragment", "")),
              "line 50: the program names no fragment function");
    EXPECT_EQ(first_complaint(with_pass("_Bias (\"Bias\", Range(0, 1)) = 0", "")),
              "the programs declare _Bias, which is no property");
    EXPECT_EQ(first_complaint(with_pass("_Bias, _Scale, _Power;", "_Bias, _Scale;")),
              "no program declares the property _Power");
    EXPECT_EQ(first_complaint(with_pass("bias_scale_power(_Bias,", "bias_scale_power(0.0,")),
              "no program uses the property _Bias");
}

TEST_F(packs, unity_passes_compile_against_a_stub_of_its_includes) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    write_pack(emit::unity_pack());
    int passes = 0;
    for (const emit::pack_file& f : shaders())
        for (const shader_pass& pass : shader_lab(f.text).passes) {
            const std::string path = replaced(f.path, ".shader", "." + pass.name + ".hlsl");
            write(path, pass.text);
            EXPECT_EQ(compiled(path, pass.vertex, pass.fragment), "") << f.path;
            ++passes;
        }
    // three built-in shaders have a pass for further lights, URP's opaque ones two for depth and normals
    EXPECT_EQ(passes, 7 + 3 + 7 + 2 * 6);
}

TEST_F(packs, unity_normals_compile_as_the_G_buffer_holds_them) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    write_pack(emit::unity_pack());
    const std::string path = "unity/Runtime/Shaders/Universal/Lit.shader";
    const shader_lab lit(file_of(emit::unity_pack(), path).text);
    ASSERT_EQ(lit.passes.size(), 3u);
    const shader_pass& pass = lit.passes.back();
    const std::string program = replaced(path, ".shader", ".hlsl");
    write(program, "#define _GBUFFER_NORMALS_OCT\n" + pass.text);
    EXPECT_EQ(compiled(program, pass.vertex, pass.fragment), "");
}

// The eye's place is that of the eye that is drawn only behind this macro.
TEST_F(packs, unity_fragments_know_which_eye_looks) {
    const std::regex fragment(R"(\w+_fragment\(fragment_input input\) : SV_Target \{\n(.*)\n)");
    int count = 0;
    for (const emit::pack_file& f : emit::unity_pack())
        for (auto at = std::sregex_iterator(f.text.begin(), f.text.end(), fragment);
             at != std::sregex_iterator(); ++at, ++count)
            EXPECT_NE((*at)[1].str().find("UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input);"),
                      std::string::npos)
                << f.path;
    EXPECT_EQ(count, 7 + 3 + 7 + 2);
}

TEST_F(packs, unity_colours_are_those_of_its_inspector) {
    for (const std::string pipeline : {"BuiltIn", "Universal"})
        for (const std::string shader : {"Highlights", "Semitransparent"}) {
            const std::string text =
                file_of(emit::unity_pack(),
                        fmt::format("unity/Runtime/Shaders/{}/{}.shader", pipeline, shader))
                    .text;
            std::smatch found;
            ASSERT_TRUE(std::regex_search(text, found, std::regex(R"(_SpecColor \(.*\) = \(([0-9.]+), )")));
            EXPECT_NEAR(std::pow((std::stod(found[1]) + 0.055) / 1.055, 2.4), 0.04, 1e-5) << "of sRGB";
        }
}

// A light whose culling mask leaves the object out has a distanceAttenuation of 0.
TEST_F(packs, every_light_of_URP_is_attenuated) {
    const std::string text = file_of(emit::unity_pack(), "unity/Runtime/Shaders/Universal/Surface.hlsl").text;
    const auto count = [&](const std::string& pattern) {
        const std::regex wanted(pattern);
        return std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), std::sregex_iterator());
    };
    EXPECT_EQ(count(R"(\.color,)"), 2);
    EXPECT_EQ(count(R"((\w+)\.distanceAttenuation \* \1\.color,)"), 2);
}

// UniversalForward is not drawn in the Deferred path.
TEST_F(packs, opaque_shaders_of_URP_are_drawn_in_every_path) {
    for (const emit::pack_file& f : shaders()) {
        if (f.path.find("/Universal/") == std::string::npos) continue;
        const bool opaque = f.path.find("Semitransparent") == std::string::npos;
        for (const std::string mode : {"UniversalForwardOnly", "DepthOnly", "DepthNormalsOnly"})
            EXPECT_EQ(f.text.find(fmt::format("\"LightMode\" = \"{}\"", mode)) != std::string::npos, opaque)
                << f.path << " " << mode;
    }
}

TEST_F(packs, a_broken_pass_is_refused) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    write_pack(emit::unity_pack());
    const std::string path = "unity/Runtime/Shaders/BuiltIn/broken.hlsl";
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"_Bias, _Scale, _Power;", "_Bias, _Scale;"},
             {"light_of_pass(", "light_of_a_pass("},
             {"#include \"Surface.hlsl\"", "#include \"Surfaces.hlsl\""},
             {"bias_scale_power(_Bias", "bias_scale_pow(_Bias"}}) {
        const shader_lab shader(
            replaced(file_of(emit::unity_pack(), "unity/Runtime/Shaders/BuiltIn/Lit.shader").text, from, to));
        write(path, shader.passes.front().text);
        EXPECT_NE(compiled(path, "surface_vertex", "surface_fragment"), "") << to;
    }
}

TEST_F(packs, unity_package_is_one) {
    const std::vector<emit::pack_file> files = emit::unity_pack();
    const auto package = nlohmann::json::parse(file_of(files, "unity/package.json").text);
    EXPECT_TRUE(
        std::regex_match(package["name"].get<std::string>(), std::regex("[a-z0-9]+(\\.[a-z0-9-]+){2,}")));
    EXPECT_TRUE(std::regex_match(package["version"].get<std::string>(), std::regex("\\d+\\.\\d+\\.\\d+")));
    EXPECT_NE(file_of(files, "unity/README.md").text.find(package["version"].get<std::string>()),
              std::string::npos);
    EXPECT_EQ(file_of(files, "unity/LICENSE.md").text,
              read_text(std::string(FRESNEL_SOURCE_DIR) + "/LICENSE"));
}

// Without a .meta an asset of a package is ignored, and two with one identifier break a project.
TEST_F(packs, every_unity_asset_has_an_identifier_of_its_own) {
    const std::vector<emit::pack_file> files = emit::unity_pack();
    std::set<std::string> paths, identifiers;
    for (const emit::pack_file& f : files)
        paths.insert(f.path);
    for (const std::string& path : paths) {
        if (path.ends_with(".meta")) continue;
        for (std::string part = path; part != "unity"; part = part.substr(0, part.rfind('/')))
            EXPECT_TRUE(paths.contains(part + ".meta")) << part;
    }
    std::size_t metas = 0;
    for (const emit::pack_file& f : files) {
        if (!f.path.ends_with(".meta")) continue;
        std::smatch found;
        ASSERT_TRUE(std::regex_search(f.text, found, std::regex("\nguid: ([0-9a-f]{32})\n"))) << f.path;
        identifiers.insert(found[1]);
        ++metas;
    }
    EXPECT_EQ(identifiers.size(), metas);
    // what projects have stored
    EXPECT_NE(file_of(files, "unity/Runtime/Shaders/BuiltIn/Lit.shader.meta")
                  .text.find("guid: 923917a35fe1c65673b256bb3a123be5"),
              std::string::npos);
}

// ---- Unreal -------------------------------------------------------------------------------------------------

TEST_F(packs, unreal_custom_nodes_of_its_readme_compile) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    const std::vector<emit::pack_file> files = emit::unreal_pack();
    write_pack(files);
    const std::string readme = file_of(files, "unreal/README.md").text;
    // what the material editor makes of the code of a node
    const auto node = [](const std::string& body) {
        return "#include \"unreal/Fresnel.ush\"\n#define MaterialFloat float\n#define MaterialFloat3 float3\n"
               "MaterialFloat3 CustomExpression0(MaterialFloat3 F0, MaterialFloat3 F82, MaterialFloat IOR, "
               "MaterialFloat3 Normal, MaterialFloat3 View) {\n" +
               body +
               "}\nfloat4 main(float3 F0 : A, float3 F82 : B, float IOR : C, float3 N : D, float3 V : E) : "
               "SV_Target {\n    return float4(CustomExpression0(F0, F82, IOR, N, V), 1.0);\n}\n";
    };
    const auto messages = [&](const std::string& body) {
        write("node.hlsl", node(body));
        return complaints("glslangValidator -D -V -S frag -e main -I. -o f.spv node.hlsl");
    };
    const std::regex block("```hlsl\n([^`]*)```");
    int nodes = 0;
    for (std::sregex_iterator b(readme.begin(), readme.end(), block), end; b != end; ++b, ++nodes)
        EXPECT_EQ(messages((*b)[1]), "");
    EXPECT_EQ(nodes, 4);
    EXPECT_NE(messages("return schlik(F0, Normal, View);"), "");
}

// ---- the folder ---------------------------------------------------------------------------------------------

// ---- Godot --------------------------------------------------------------------------------------------------

// A normal map of x = 0.6 and y = 0 stands for z = 0.8, which the depth mixes with the surface's own normal.
TEST_F(packs, godot_bends_normals_as_the_engine_does) {
    const std::string shader = file_of(emit::godot_pack(), "godot/addons/fresnel/rim.gdshader").text;
    const std::size_t begin = shader.find("vec3 bent_normal("), end = shader.find("\n}\n", begin) + 3;
    const std::string bent =
        replaced(shader.substr(begin, end - begin), "texture(normal_texture, uv).xy", "uv");
    const std::vector<float> depths = {1, 0, 0.5f};
    try {
        const std::vector<float> found = render::open_opengl()->run(
            "#version 430\nlayout(local_size_x = 64) in;\n"
            "layout(std430, binding = 0) readonly buffer A { float depths[]; };\n"
            "layout(std430, binding = 1) writeonly buffer B { float results[]; };\nfloat normal_strength;\n" +
                bent +
                "void main() {\n    uint i = gl_GlobalInvocationID.x;\n    if (i >= 3u) return;\n"
                "    normal_strength = depths[i];\n    vec3 n = bent_normal(vec3(0, 0, 1), vec3(1, 0, 0), "
                "vec3(0, 1, 0), vec2(0.8, 0.5));\n    results[2u * i] = n.x;\n    results[2u * i + 1u] = "
                "n.z;\n}\n",
            depths, {3, 2});
        const std::vector<double> wanted = {0.6, 0.8, 0, 1, 0.316228, 0.948683};
        for (std::size_t i = 0; i < wanted.size(); ++i)
            EXPECT_NEAR(double(found[i]), wanted[i], 1e-5) << i;
    } catch (const render::no_device& reason) {
        GTEST_SKIP() << "skipped: " << reason.what();
    }
}

// ---- MaterialX ----------------------------------------------------------------------------------------------

// The words that MaterialX changes where it gives a source in GLSL to Metal.
std::string as_metal(std::string text) {
    text = std::regex_replace(text, std::regex("\\bvec([23])\\b"), "float$1");
    return std::regex_replace(text, std::regex("\\bout (float3?) "), "thread $1& ");
}

// No Metal compiler can be had: clang reads the sources as the C++ with vectors that they are.
TEST_F(packs, materialx_sources_are_Metal_too) {
    if (!has_command("clang++-19")) GTEST_SKIP() << "skipped: no clang++-19";
    const std::string command =
        std::string("clang++-19 -std=c++14 -fsyntax-only -nostdinc -isystem ") + FRESNEL_SOURCE_DIR +
        "/tests/metal -Wall -Wextra -Wno-unused-function -Wno-unused-parameter -Werror all.cpp";
    std::string all = "#include <metal_stdlib>\n#define thread\nusing namespace metal;\n";
    int count = 0;
    for (const emit::pack_file& f : emit::materialx_pack()) {
        if (!f.path.ends_with(".glsl")) continue;
        write(f.path, as_metal(f.text));
        if (f.path.find("/lib/") == std::string::npos)
            all += fmt::format("namespace source_{} {{\n#include \"{}\"\n}}\n", count++, f.path);
    }
    EXPECT_GT(count, 30);
    write("all.cpp", all);
    EXPECT_EQ(complaints(command), "");
    write("all.cpp", all + "float broken(float x) { return clamp_of(x); }\n");
    EXPECT_NE(complaints(command).find("clamp_of"), std::string::npos);
}

TEST_F(packs, templates_come_out_as_they_are) {
    for (const emit::pack_file& f : shaders())
        EXPECT_EQ(f.text, read_text(templates + f.path)) << f.path;
}

class packs_command : public command_test {};

TEST_F(packs_command, what_is_written_is_what_is_checked) {
    EXPECT_EQ(run("shader --write shaders").code, 0);
    EXPECT_EQ(run("shader --check shaders").code, 0);
    const std::string index = read_text(folder / "work/shaders/README.md");
    for (const std::string place : {"unity/", "unreal/", "glsl/fresnel.glsl", "osl/fresnel.osl"}) {
        EXPECT_NE(index.find("](" + place + ")"), std::string::npos) << place;
        EXPECT_TRUE(std::filesystem::exists(folder / "work/shaders" / place)) << place;
    }
    write("shaders/unity/README.md", "edited by hand");
    write("shaders/extra.txt", "");
    const outcome changed = run("shader --check shaders");
    EXPECT_EQ(changed.code, 1);
    EXPECT_NE(changed.out.find("unity/README.md differs"), std::string::npos);
    EXPECT_NE(changed.out.find("extra.txt is not generated"), std::string::npos);
}

} // namespace fresnel::test
