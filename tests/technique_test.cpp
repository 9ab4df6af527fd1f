// The programs of `fresnel shader MODEL --technique T`: every model by every technique in every dialect, compiled.

#include "command.hpp"
#include "shader_compilers.hpp"

#include "analysis/model_table.hpp"
#include "emit/technique.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <regex>
#include <set>

namespace fresnel::test {

namespace {

using emit::stage;

// A table has rows for f0 or n_t alone: the other parameters of its model have their usual values.
emit::model_request usual_request(std::string_view technique, const std::string& model) {
    emit::model_request request{model};
    if (technique != "lut") return request;
    for (const parameter& p : find_model<double>(model).parameters)
        if (p.name != "f0" && p.name != "n_t" && p.name != "n_i")
            request.fixed[std::string(p.name)].fill(p.default_value);
    return request;
}

std::string program_text(std::string_view dialect, std::string_view technique, const std::string& model,
                         stage stages = stage::both) {
    return emit::technique_text(emit::find_dialect(dialect), emit::find_technique(technique),
                                usual_request(technique, model), stages, "technique_test");
}

std::string text_of(std::string_view dialect, std::string_view technique, const emit::model_request& wanted,
                    stage stages = stage::both) {
    return emit::technique_text(emit::find_dialect(dialect), emit::find_technique(technique), wanted, stages,
                                "technique_test");
}

bool contains(const std::string& text, std::string_view piece) {
    return text.find(piece) != std::string::npos;
}

// ---- Metal ----

const std::string metal_head = "#include <metal_stdlib>\n";
const std::string clang_for_metal =
    std::string("clang++-19 -std=c++14 -fsyntax-only -nostdinc -isystem ") + FRESNEL_SOURCE_DIR +
    "/tests/metal -Wall -Wextra -Wno-unused-parameter -Wno-unknown-attributes -Werror all.cpp";

// One of many programs in a text that has the header once.
std::string in_namespace(std::string text, int number) {
    EXPECT_TRUE(contains(text, metal_head));
    text.erase(text.find(metal_head), metal_head.size());
    return fmt::format("namespace program_{} {{\n{}}}\n", number, text);
}

class techniques : public shader_test {
protected:
    // Every model by every technique; `few`: every model by two of them and two models by the others, since the
    // functions and what stands around them meet in no other way.
    template <class Body>
    void for_each_program(bool few, Body&& body) {
        for (const emit::technique& t : emit::techniques())
            for (const model_row<double>& row : model_table<double>())
                if ((!few || t.name == "per-pixel" || t.name == "per-vertex" || row.name == "schlick" ||
                     row.name == "dielectric") &&
                    !(t.name == "lut" && row.name == "schlick_internal")) // has a critical angle
                    body(std::string(t.name), std::string(row.name));
    }

    // All files in one process: glslang reads its own definitions once.
    void check_glsl(const std::string& dialect) {
        if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
        int programs = 0;
        for_each_program(false, [&](const std::string& technique, const std::string& model) {
            const std::string name = technique + "_" + model;
            write(name + ".vert", program_text(dialect, technique, model, stage::vertex));
            write(name + ".frag", program_text(dialect, technique, model, stage::fragment));
            ++programs;
        });
        EXPECT_EQ(programs, 7 * 26 - 1);
        EXPECT_EQ(complaints("glslangValidator *.vert *.frag | (! grep -E 'ERROR|error')"), "");
        // both stages meet, and glslang's instructions are valid
        for (const std::string model : {"schlick", "dielectric", "gulbrandsen"})
            for (const std::string technique : {"per-vertex", "per-pixel", "semitransparent"}) {
                const std::string name = technique + "_" + model;
                EXPECT_EQ(complaints(fmt::format("glslangValidator -l {0}.vert {0}.frag", name)), "");
                if (dialect == "glsl" && has_command("spirv-val")) {
                    EXPECT_EQ(complaints(fmt::format("glslangValidator -G --aml --amb -o p.spv {}.frag && "
                                                     "spirv-val p.spv",
                                                     name)),
                              "");
                }
            }
    }

    void check_hlsl(const std::string& dialect) {
        if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
        for_each_program(true, [&](const std::string& technique, const std::string& model) {
            write("p.hlsl", program_text(dialect, technique, model));
            EXPECT_EQ(complaints("glslangValidator -D -V -S vert -e vertex_main -o v.spv p.hlsl && "
                                 "glslangValidator -D -V -S frag -e fragment_main -o f.spv p.hlsl"),
                      "")
                << technique << " " << model;
            // glslang's own instructions for tex2D are refused by spirv-val
            if (dialect == "hlsl" && has_command("spirv-val")) {
                EXPECT_EQ(complaints("spirv-val v.spv && spirv-val f.spv"), "") << technique << " " << model;
            }
        });
    }
};

} // namespace

TEST_F(techniques, every_program_compiles_as_GLSL) { check_glsl("glsl"); }
TEST_F(techniques, every_program_compiles_as_GLSL_ES) { check_glsl("essl"); }
TEST_F(techniques, programs_compile_as_HLSL) { check_hlsl("hlsl"); }
TEST_F(techniques, programs_compile_as_HLSL_of_shader_models_2_and_3) { check_hlsl("cg"); }

TEST_F(techniques, every_program_compiles_as_WGSL) {
    if (!has_command("fresnel-naga")) GTEST_SKIP() << "skipped: no fresnel-naga";
    for_each_program(false, [&](const std::string& technique, const std::string& model) {
        write(technique + "_" + model + ".wgsl", program_text("wgsl", technique, model));
    });
    EXPECT_EQ(complaints("fresnel-naga --bulk-validate *.wgsl"), "");
}

// No Metal compiler can be had outside Apple's machines. The language is C++ with vectors, so clang reads the programs, all
// in one text, with a header of ours.
TEST_F(techniques, every_program_is_MSL_as_far_as_clang_can_tell) {
    if (!has_command("clang++-19")) GTEST_SKIP() << "skipped: no clang++-19";
    std::string all = metal_head;
    int count = 0;
    for_each_program(false, [&](const std::string& technique, const std::string& model) {
        all += in_namespace(program_text("msl", technique, model), count++);
    });
    write("all.cpp", all);
    EXPECT_EQ(complaints(clang_for_metal), "");
    write("all.cpp", all.replace(all.rfind("u.ambient_color"), 15, "u.ambient_colour"));
    EXPECT_TRUE(contains(complaints(clang_for_metal), "ambient_colour"));
}

// The words of the programs that call the function.
std::set<std::string> words_of_programs(std::string_view dialect, std::string_view technique) {
    const std::string usual = program_text(dialect, technique, "schlick");
    const std::regex word("[A-Za-z]\\w*");
    std::set<std::string> names;
    for (auto at = std::sregex_iterator(usual.begin(), usual.end(), word); at != std::sregex_iterator(); ++at)
        names.insert(at->str());
    return names;
}

template <class Body>
void for_each_named_program(std::string_view dialect, Body&& body) {
    int programs = 0;
    for (const std::string_view technique : {"per-vertex", "per-pixel", "highlights", "semitransparent"})
        for (const std::string& name : words_of_programs(dialect, technique)) {
            body(fmt::format("{}_{}", technique, programs), technique,
                 emit::model_request{"schlick", {}, name});
            ++programs;
        }
    EXPECT_GT(programs, 300) << dialect;
}

TEST_F(techniques, a_function_may_be_called_whatever_a_program_holds) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    for (const std::string_view dialect : {"glsl", "essl"}) {
        for_each_named_program(dialect, [&](const std::string& file, auto technique, const auto& request) {
            write(file + ".vert", text_of(dialect, technique, request, stage::vertex));
            write(file + ".frag", text_of(dialect, technique, request, stage::fragment));
        });
        EXPECT_EQ(complaints("glslangValidator *.vert *.frag | (! grep -E 'ERROR|error')"), "") << dialect;
    }
}

// glslang takes one file of HLSL at a time: of two techniques the stage that calls the function.
TEST_F(techniques, a_function_may_be_called_whatever_a_program_in_HLSL_holds) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    for (const std::string_view dialect : {"hlsl", "cg"}) {
        for_each_named_program(dialect, [&](const std::string& file, auto technique, const auto& request) {
            if (technique == "per-vertex") write(file + ".vert", text_of(dialect, technique, request));
            if (technique == "per-pixel") write(file + ".frag", text_of(dialect, technique, request));
        });
        for (const auto& [files, entry] : {std::pair{"*.vert", "vertex_main"}, {"*.frag", "fragment_main"}})
            EXPECT_EQ(
                complaints(fmt::format("ls {} | xargs -P 2 -I FILE glslangValidator -D -V -e {} -o FILE.spv "
                                       "FILE | (! grep ERROR)",
                                       files, entry)),
                "")
                << dialect;
    }
}

TEST_F(techniques, a_function_may_be_called_whatever_a_program_in_WGSL_holds) {
    if (!has_command("fresnel-naga")) GTEST_SKIP() << "skipped: no fresnel-naga";
    for_each_named_program("wgsl", [&](const std::string& file, auto technique, const auto& request) {
        write(file + ".wgsl", text_of("wgsl", technique, request));
    });
    EXPECT_EQ(complaints("fresnel-naga --bulk-validate *.wgsl"), "");
}

TEST_F(techniques, a_function_may_be_called_whatever_a_program_in_MSL_holds) {
    if (!has_command("clang++-19")) GTEST_SKIP() << "skipped: no clang++-19";
    std::string all = metal_head;
    int count = 0;
    for_each_named_program("msl", [&](const std::string&, auto technique, const auto& request) {
        all += in_namespace(text_of("msl", technique, request), count++);
    });
    write("all.cpp", all);
    EXPECT_EQ(complaints(clang_for_metal), "");
}

TEST_F(techniques, each_stage_of_a_joint_text_is_whole_too) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    for (const emit::technique& t : emit::techniques()) {
        write("v.hlsl", program_text("hlsl", t.name, "f82", stage::vertex));
        write("f.hlsl", program_text("hlsl", t.name, "f82", stage::fragment));
        EXPECT_EQ(complaints("glslangValidator -D -V -S vert -e vertex_main -o v.spv v.hlsl && "
                             "glslangValidator -D -V -S frag -e fragment_main -o f.spv f.hlsl"),
                  "");
    }
}

TEST_F(techniques, a_broken_program_is_refused_by_each_compiler) {
    const auto broken = [](std::string text) { // a uniform that nobody declares
        return text.replace(text.rfind("ambient_color"), 13, "ambient_colour");
    };
    if (has_command("glslangValidator")) {
        for (const std::string dialect : {"glsl", "essl"}) {
            write("p.frag", broken(program_text(dialect, "per-pixel", "schlick", stage::fragment)));
            EXPECT_TRUE(contains(complaints("glslangValidator *.frag | (! grep ERROR)"), "ambient_colour"));
        }
        for (const std::string dialect : {"hlsl", "cg"}) {
            write("p.hlsl", broken(program_text(dialect, "per-pixel", "schlick")));
            EXPECT_TRUE(
                contains(complaints("glslangValidator -D -V -S frag -e fragment_main -o f.spv p.hlsl"),
                         "ambient_colour"));
        }
    }
    if (has_command("fresnel-naga")) {
        write("p.wgsl", broken(program_text("wgsl", "per-pixel", "schlick")));
        EXPECT_TRUE(contains(complaints("fresnel-naga --bulk-validate *.wgsl"), "ambient_colour"));
    }
}

// What distinguishes the programs is where and of what F is made.
TEST_F(techniques, each_technique_makes_F_where_it_says) {
    for (const emit::dialect& d : emit::dialects()) {
        const auto stage_text = [&](std::string_view technique, stage s) {
            return program_text(d.id, technique, "schlick", s);
        };
        const std::string own = d.id == "wgsl" ? "schlick_rgb(" : "schlick(";
        const std::string f0 = fmt::format("{}f0", d.uniform);
        EXPECT_TRUE(contains(stage_text("per-vertex", stage::vertex), own + f0 + ", cos_i)")) << d.id;
        EXPECT_FALSE(contains(stage_text("per-vertex", stage::fragment), own)) << d.id;
        EXPECT_FALSE(contains(stage_text("per-vertex", stage::fragment), "normal_map")) << d.id;
        EXPECT_TRUE(contains(stage_text("per-pixel", stage::fragment), own + f0 + ", cos_i)")) << d.id;
        EXPECT_FALSE(contains(stage_text("per-pixel", stage::vertex), own)) << d.id;
        EXPECT_TRUE(contains(stage_text("none", stage::fragment), own + f0 + ", 1.0")) << d.id;
        EXPECT_TRUE(contains(stage_text("one-minus-cos", stage::fragment), "F = one_minus_cos(cos_i)"))
            << d.id;
        EXPECT_FALSE(contains(stage_text("one-minus-cos", stage::fragment), "schlick(")) << d.id;
        EXPECT_FALSE(contains(stage_text("lut", stage::fragment), own)) << d.id;
        EXPECT_TRUE(contains(stage_text("lut", stage::fragment), "fresnel_table")) << d.id;
        EXPECT_TRUE(contains(stage_text("highlights", stage::fragment), own + f0 + ", cos_h)")) << d.id;
    }
}

TEST_F(techniques, fixed_parameters_are_no_uniforms) {
    const auto text = [](const emit::model_request& wanted, std::string_view technique) {
        return emit::technique_text(emit::find_dialect("glsl"), emit::find_technique(technique), wanted,
                                    stage::both, "technique_test");
    };
    EXPECT_TRUE(contains(text({"schlick"}, "per-pixel"), "uniform vec3 f0;"));
    EXPECT_FALSE(contains(text({"schlick", {{"f0", {0.04, 0.04, 0.04}}}}, "per-pixel"), "uniform vec3 f0;"));
    EXPECT_TRUE(contains(text({"schlick", {{"f0", {1, 0.78, 0.34}}}}, "per-pixel"), "vec3(1.0, 0.78, 0.34)"));
    // the index of a dielectric hardly has a colour
    EXPECT_TRUE(contains(text({"dielectric"}, "per-pixel"), "uniform float n_t;"));
    EXPECT_TRUE(contains(text({"conductor"}, "per-pixel"), "uniform vec3 n_t;"));
}

TEST_F(techniques, a_table_has_rows_where_one_parameter_is_left) {
    const auto text = [](const emit::model_request& wanted) {
        return emit::technique_text(emit::find_dialect("glsl"), emit::find_technique("lut"), wanted,
                                    stage::fragment, "technique_test");
    };
    const std::string by_f0 = text({"schlick"});
    EXPECT_TRUE(contains(by_f0, "uniform float f0;"));
    EXPECT_TRUE(contains(by_f0, "`fresnel lut schlick --by f0 --map cos` bakes it"));
    EXPECT_TRUE(contains(text({"dielectric"}), "uniform float eta;"));
    const std::string one_row = text({"schlick", {{"f0", {1, 0.78, 0.34}}}});
    EXPECT_FALSE(contains(one_row, "table_range"));
    EXPECT_TRUE(contains(one_row, "`fresnel lut schlick --fix f0=1,0.78,0.34 --map cos` bakes it"));
    EXPECT_TRUE(
        contains(text({"f82", {{"f82", {0.9, 0.9, 0.9}}}}), "--fix f82=0.9 --by f0 --map cos` bakes"));
}

// A table has one channel unless a constant is a colour; the others are 0 where it is read.
TEST_F(techniques, a_table_is_read_in_the_channels_that_it_has) {
    for (const emit::dialect& d : emit::dialects()) {
        const auto fragment = [&](const emit::model_request& wanted) {
            return text_of(d.id, "lut", wanted, stage::fragment);
        };
        const auto reads = [&](const std::string& text, emit::shape type, std::string_view channels) {
            const std::string F = d.id == "wgsl" ? "let" : std::string(d.type(type));
            return std::regex_search(text,
                                     std::regex(fmt::format("{} F = .*fresnel_table.*\\.{};", F, channels)));
        };
        for (const emit::model_request& wanted :
             std::vector<emit::model_request>{{"schlick"},
                                              {"dielectric"},
                                              {"schlick", {{"f0", {0.04, 0.04, 0.04}}}},
                                              {"conductor", {{"n_t", {1, 1, 1}}, {"k_t", {3, 3, 3}}}}})
            EXPECT_TRUE(reads(fragment(wanted), emit::shape::scalar, "r")) << d.id << fragment(wanted);
        for (const emit::model_request& wanted : std::vector<emit::model_request>{
                 {"schlick", {{"f0", {1, 0.78, 0.34}}}}, {"f82", {{"f82", {1, 0.9, 0.8}}}}})
            EXPECT_TRUE(reads(fragment(wanted), emit::shape::three, "rgb")) << d.id << fragment(wanted);
    }
}

TEST_F(techniques, a_table_of_colours_is_read_as_WGSL_and_HLSL_too) {
    const emit::model_request gold{"schlick", {{"f0", {1, 0.78, 0.34}}}};
    if (has_command("fresnel-naga")) {
        write("p.wgsl", text_of("wgsl", "lut", gold));
        EXPECT_EQ(complaints("fresnel-naga --bulk-validate *.wgsl"), "");
    }
    if (has_command("glslangValidator")) {
        write("p.hlsl", text_of("hlsl", "lut", gold));
        EXPECT_EQ(complaints("glslangValidator -D -V -S frag -e fragment_main -o f.spv p.hlsl"), "");
    }
}

TEST_F(techniques, a_name_of_the_program_is_not_taken_twice) {
    if (!has_command("glslangValidator")) GTEST_SKIP() << "skipped: no glslangValidator";
    for (const std::string name :
         {"environment", "main", "F", "f0", "incidence_cosine", "world_normal", "mix"}) {
        const auto text = [&](std::string_view dialect, stage s) {
            return emit::technique_text(emit::find_dialect(dialect), emit::find_technique("per-pixel"),
                                        {"schlick", {}, name}, s, "technique_test");
        };
        write(name + ".frag", text("glsl", stage::fragment));
        EXPECT_EQ(complaints("glslangValidator " + name + ".frag"), "");
        write("p.hlsl", text("hlsl", stage::both));
        EXPECT_EQ(complaints("glslangValidator -D -V -S frag -e fragment_main -o f.spv p.hlsl"), "");
    }
}

class technique_command : public command_test {};

TEST_F(technique_command, prints_one_stage_or_both) {
    const std::string both = run("shader schlick --technique per-pixel").out;
    EXPECT_TRUE(contains(both, "vertex stage"));
    EXPECT_TRUE(contains(both, "fragment stage"));
    const std::string vertex = run("shader schlick --technique per-pixel --stage vertex").out;
    EXPECT_EQ(vertex.rfind("#version 330 core\n", 0), 0u);
    EXPECT_TRUE(contains(vertex, "gl_Position"));
    EXPECT_TRUE(contains(run("shader schlick --technique lut --lang cg").out, "tex2D(fresnel_table"));
}

// The command that a program prints bakes the table that it reads.
TEST_F(technique_command, the_command_in_a_program_bakes_its_table) {
    for (const auto& [wanted, channels] : std::vector<std::pair<std::string, int>>{
             {"schlick", 1},
             {"dielectric", 1},
             {"dielectric --fix n_i=1.33 --fix n_t=1.5", 1},
             {"conductor --fix k_t=3", 1},
             {"gulbrandsen --material gold", 3},
             {"f82 --material copper", 3},
             {"f82 --fix f82=0.9", 1},
             {"hoffman --fix f82=0.9,0.8,0.7 --fix f90=1 --fix power=5", 3},
             {"schlick --fix f0=1,0.78,0.34", 3},
             {"one_minus_cos", 1}}) {
        const std::string text = run("shader " + wanted + " --technique lut --stage fragment").out;
        const std::size_t begin = text.find("`fresnel lut "), end = text.find('`', begin + 1);
        ASSERT_NE(end, std::string::npos) << wanted << text;
        const nlohmann::json table = json(text.substr(begin + 9, end - begin - 9) + " --json");
        EXPECT_EQ(table["channels"], channels) << wanted;
        EXPECT_EQ(table["map"], "cos") << wanted;
        EXPECT_EQ(contains(text, "vec3 F = "), channels == 3) << text;
        EXPECT_EQ(!table["by"].is_null(), contains(text, "table_range")) << text;
    }
}

TEST_F(technique_command, a_table_that_cannot_be_baked_is_refused) {
    expect_refused("shader conductor --technique lut",
                   {"--technique lut", "n_t and k_t", "--fix n_t=VALUE --fix k_t=VALUE"});
    expect_refused("shader conductor --technique lut --fix n_t=0.2", {"leaves k_t open", "--fix k_t"});
    expect_refused("shader bias_scale_power --technique lut", {"bias and scale and power", "--fix"});
    expect_refused("shader gulbrandsen --technique lut --fix r=0.9", {"leaves g open", "--material"});
    expect_refused("shader schlick_internal --technique lut", {"schlick_internal", "critical angle"});
    expect_refused("shader schlick_internal --technique lut --fix eta=0.7",
                   {"critical angle", "--fix eta=0.7`"});
    expect_refused(
        "shader dielectric --technique lut --fix n_i=1.5 --fix n_t=1",
        {"n_i = 1.5, n_t = 1", "critical angle", "fresnel lut dielectric --fix n_i=1.5 --fix n_t=1`"});
}

TEST_F(technique_command, bad_input_is_refused) {
    expect_refused("shader schlick --technique per-pixle",
                   {"--technique", "per-pixle", "per-pixel", "one-minus-cos", "lut"});
    expect_refused("shader schlick --technique lut --stage geometry",
                   {"--stage", "geometry", "vertex", "fragment"});
    expect_refused("shader schlick --stage vertex", {"--stage", "--technique"});
    expect_refused("shader schlick --technique lut --lang osl", {"--lang", "osl", "glsl", "wgsl"});
    expect_refused("shader schlick --technique lut --lang hlls", {"--lang", "hlls", "hlsl"});
    expect_refused("shader schlick dielectric --technique lut", {"--technique", "one MODEL"});
    expect_refused("shader --technique lut", {"MODEL"});
    expect_refused("shader schlik --technique lut", {"schlik", "schlick"});
    expect_refused("shader schlick --technique lut --fix f1=2", {"f1", "f0"});
    expect_refused("shader schlick --technique per-pixel --fix f0=2", {"f0", "2", "1"});
}

} // namespace fresnel::test
