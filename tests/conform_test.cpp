// Other people's functions judged: of each kind of mistake that is found in the wild one, which must be found, and its
// twin without the mistake, which must pass.

#include "command.hpp"

#include "conform/binding.hpp"
#include "conform/expression.hpp"
#include "conform/message.hpp"
#include "conform/signature.hpp"
#include "error.hpp"

namespace fresnel::test {
namespace {

// ---- mistakes and their twins -----------------------------------------------------------------------------

struct mistake {
    std::string file, right, function, model, finding;
    std::string options = "";

    friend std::ostream& operator<<(std::ostream& out, const mistake& m) { return out << m.file; }
};

const std::vector<mistake> mistakes = {
    {"pow_negative_base.glsl", "pow_negative_base_right.glsl", "F_Schlick", "schlick", "are NaN for cosines"},
    {"wrong_f90.hlsl", "wrong_f90_right.hlsl", "F_Schlick", "schlick_f90", "are off by more"},
    {"missing_total_reflection.glsl", "missing_total_reflection_right.glsl", "fresnel", "dielectric",
     "are NaN"},
    {"digits_lost.glsl", "missing_total_reflection_right.glsl", "fresnel", "dielectric", "lose their digits"},
    {"swapped_index.wgsl", "swapped_index_right.wgsl", "fresnel", "dielectric", "are off by more"},
    {"equal_media.hlsl", "equal_media_right.hlsl", "fresnel", "dielectric", "are NaN"},
    {"conductor_negative.hlsl", "conductor_right.hlsl", "conductor", "conductor", "are negative"},
    {"ambient_ignored.glsl", "ambient_ignored_right.glsl", "conductor", "conductor", "are off by more"},
    {"large_index_form.glsl", "conductor_right.hlsl", "conductor", "conductor", "are off by more"},
    {"gulbrandsen_k2.hlsl", "gulbrandsen_k2_right.hlsl", "artist_fresnel", "gulbrandsen", "are off by more",
     "--range r=0.001,0.99"},
    {"reflectance_one.wgsl", "reflectance_one_right.wgsl", "artist_fresnel", "gulbrandsen", "are NaN"},
    {"tint_dropped.wgsl", "tint_right.wgsl", "f82_tint", "f82_tint", "are off by more"},
    {"tint_negative.wgsl", "tint_right.wgsl", "f82_tint", "f82_tint", "are negative"},
    {"rim_above_one.hlsl", "rim_above_one_right.hlsl", "rim", "bias_scale_power", "are above 1"},
    {"jump.glsl", "jump_right.glsl", "F", "schlick", "it jumps"},
    {"behind_surface.glsl", "behind_surface_right.glsl", "fresnel", "schlick",
     "no reflectance for directions"},
    {"gaussian_weight.hlsl", "", "F_Schlick", "schlick", "are off by more"},
};

class conform_mistakes : public command_test, public testing::WithParamInterface<mistake> {
protected:
    // The report, and the exit code.
    std::pair<nlohmann::json, int> report(const std::string& file) const {
        const mistake& m = GetParam();
        const outcome result = run("conform '" FRESNEL_SOURCE_DIR "/tests/conform/" + file + "' --function " +
                                   m.function + " --as " + m.model + " " + m.options + " --json");
        if (result.err.find("cannot be run here") != std::string::npos) return {result.err, -1};
        return {nlohmann::json::parse(result.out), result.code};
    }
};

TEST_P(conform_mistakes, are_found_and_their_twins_pass) {
    const auto [wrong, code] = report(GetParam().file);
    if (code == -1) GTEST_SKIP() << "skipped: " << wrong.get<std::string>();
    EXPECT_EQ(code, 1);
    EXPECT_FALSE(wrong["conforms"].get<bool>());
    EXPECT_FALSE(wrong["first_failures"].empty() && wrong["discontinuities"].empty());
    std::string findings;
    for (const nlohmann::json& finding : wrong["findings"])
        findings += finding.get<std::string>() + "\n";
    EXPECT_NE(findings.find(GetParam().finding), std::string::npos) << findings;

    if (GetParam().right.empty()) return;
    const auto [right, right_code] = report(GetParam().right);
    if (right_code == -1) GTEST_SKIP() << "skipped: " << right.get<std::string>();
    EXPECT_EQ(right_code, 0) << right["findings"].dump() << right["first_failures"].dump();
    EXPECT_TRUE(right["findings"].empty()) << right["findings"].dump();
    EXPECT_EQ(right["nan"], 0);
    EXPECT_LT(right["rms_error"].get<double>(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(kinds, conform_mistakes, testing::ValuesIn(mistakes), [](const auto& each) {
    const std::string& file = each.param.file;
    return file.substr(0, file.find('.'));
});

// ---- the command ------------------------------------------------------------------------------------------

class conform : public command_test {
protected:
    static constexpr const char* schlick = "float F(float f0, float u) {\n"
                                           "    float m = 1.0 - u, m2 = m * m;\n"
                                           "    return f0 + (1.0 - f0) * m2 * m2 * m;\n"
                                           "}\n";

    void expect_schlick(const std::string& file, const std::string& function) const {
        const outcome result = run("conform " + file + " --function " + function + " --as schlick");
        if (result.err.find("cannot be run here") != std::string::npos) return; // as its own test says
        EXPECT_EQ(result.code, 0) << file << "\n" << result.out << result.err;
    }
};

TEST_F(conform, report_has_the_promised_keys) {
    write("a.glsl", schlick);
    const nlohmann::json report = json("conform a.glsl --function F --as schlick --json");
    for (const char* key : {"max_error", "nan", "negative", "above_one", "first_failures"})
        EXPECT_TRUE(report.contains(key)) << key;
    EXPECT_LT(report["max_error"].get<double>(), 1e-6);
    EXPECT_EQ(report["arguments"], (nlohmann::json{{"f0", "f0"}, {"u", "cos_i"}}));
}

TEST_F(conform, text_report_says_what_was_run_and_where) {
    write("a.glsl", schlick);
    const outcome good = run("conform a.glsl --function F --as schlick");
    EXPECT_EQ(good.code, 0) << good.err;
    for (const char* piece :
         {"float F(float f0, float u)", "as schlick: f0 = f0, u = cos_i", "OpenGL", "is schlick"})
        EXPECT_NE(good.out.find(piece), std::string::npos) << piece << "\n" << good.out;
    const outcome bad = run("conform a.glsl --function F --as f82 --fix f82=0.2");
    EXPECT_EQ(bad.code, 1);
    EXPECT_NE(bad.err.find("fresnel: a.glsl: F is not f82: "), std::string::npos) << bad.err;
    EXPECT_NE(bad.out.find("must be"), std::string::npos) << bad.out;
}

TEST_F(conform, an_input_fails_once_however_many_its_channels) {
    write("a.glsl", "vec3 F(vec3 f0, float u) { return f0 + (1.0 - f0) * pow(1.0 - u, 5.0); }\n");
    const outcome result = run("conform a.glsl --function F --as schlick --json");
    EXPECT_EQ(result.code, 1);
    const nlohmann::json failures = nlohmann::json::parse(result.out)["first_failures"];
    ASSERT_EQ(failures.size(), 5u);
    std::set<std::string> inputs;
    for (const nlohmann::json& failure : failures)
        EXPECT_TRUE(inputs.insert(failure["inputs"].dump()).second) << failure.dump();
}

TEST_F(conform, arguments_are_expressions) {
    write("a.glsl", "float F(float one, float u, vec3 unused) {\n    float m = 1.0 + u;\n"
                    "    return 0.04 * one + (1.0 - 0.04 * one) * m * m * m * m * m;\n}\n");
    json("conform a.glsl --function F --as schlick --fix f0=0.04 --args '1, -cos_i, vec3(0.5)' --json");
    write("b.glsl",
          "float F(float cosine, float inverse) {\n    float a = (inverse - 1.0) / (inverse + 1.0);\n"
          "    float m = 1.0 - cosine, m2 = m * m;\n    return a * a + (1.0 - a * a) * m2 * m2 * m;\n}\n");
    json("conform b.glsl --function F --as schlick --args 'cos_i, 1/eta' --range f0=0.02,0.9 --json");
    EXPECT_EQ(run("conform b.glsl --function F --as schlick --args 'cos_i, 1/eta + 0.1'").code, 1);
}

TEST_F(conform, exact_error_is_that_of_the_model) {
    write("a.glsl", schlick);
    const nlohmann::json report =
        json("conform a.glsl --function F --as schlick --range f0=0.0170133,0.1836735 --exact --json");
    // eta in [1.3, 2.5]: the registry's error of schlick
    EXPECT_NEAR(report["exact_max_error"].get<double>(), 0.0824, 0.0005);
}

TEST_F(conform, fresnel_text_conforms_to_itself) {
    for (const char* model :
         {"dielectric", "conductor", "schlick", "f82_tint", "gulbrandsen", "powers_3_6_9"})
        for (const char* language : {"glsl", "hlsl"}) {
            const std::string name = std::string("ours.") + language;
            write(name, run(std::string("shader ") + model + " --lang " + language).out);
            const std::string range = std::string(model) == "gulbrandsen" ? " --range r=0.001,0.999" : "";
            const outcome result = run("conform " + name + " --function " + model + " --as " + model + range);
            EXPECT_EQ(result.code, 0) << result.out << result.err;
        }
}

// ---- whole files ------------------------------------------------------------------------------------------

TEST_F(conform, a_byte_order_mark_is_no_part_of_the_text) {
    const std::string mark = "\xEF\xBB\xBF";
    const std::string hlsl_and_glsl = mark + schlick;
    write("a.glsl", hlsl_and_glsl);
    write("a.hlsl", hlsl_and_glsl);
    write("a.wgsl", mark +
                        "fn F(f0: f32, u: f32) -> f32 {\n    return f0 + (1.0 - f0) * pow(max(1.0 - u, 0.0), "
                        "5.0);\n}\n");
    for (const char* file : {"a.glsl", "a.hlsl", "a.wgsl"})
        expect_schlick(file, "F");
}

TEST_F(conform, fresnel_s_own_programs_conform) {
    for (const std::string language : {"glsl", "essl", "hlsl", "wgsl"}) {
        write(language, run("shader schlick --technique per-pixel --stage fragment --lang " + language).out);
        expect_schlick(language + " --lang " + (language == "essl" ? "glsl" : language),
                       language == "wgsl" ? "schlick_rgb" : "schlick");
    }
}

TEST_F(conform, whole_glsl_files_are_judged_by_their_function) {
    write("a.frag",
          std::string("#version 300 es\n"
                      "#extension GL_OES_standard_derivatives : enable // of WebGL 1\n"
                      "precision highp float;\n"
                      "layout(location = 0) in vec3 normal;\nflat in int kind;\n"
                      "in vertex { vec2 at; } from;\nuniform vec3 eye;\n"
                      "layout(location = 0) out vec4 color;\n") +
              schlick +
              "vec3 kept(in vec3 v, out float w) { w = v.x; return v + normal; }\n"
              "void main() {\n    if (kind > 0) discard;\n"
              "    color = vec4(F(0.04, dot(normal, eye)) + from.at.x * dFdx(gl_FragCoord.x));\n}\n");
    write("b.frag", std::string("varying vec3 normal;\n") + schlick +
                        "void main() { gl_FragColor = vec4(F(0.04, normal.z)); }\n");
    for (const char* file : {"a.frag", "b.frag"})
        expect_schlick(file, "F");
    write("bad.frag",
          "#version 330\n\nin vec3 normal;\nfloat F(float f0, float u) {\n    return f0 + v;\n}\n");
    expect_refused("conform bad.frag --function F --as schlick", {"fresnel: bad.frag:5: ", "'v' undeclared"});
    write("missing.frag", std::string("#version 330\n\n#extension GL_NV_nothing : require\n") + schlick);
    expect_refused("conform missing.frag --function F --as schlick",
                   {"fresnel: missing.frag:3: ", "GL_NV_nothing"});
}

TEST_F(conform, whole_hlsl_and_wgsl_files_are_judged_by_their_function) {
    write("a.hlsl", std::string("cbuffer frame : register(b0) { float3 eye; };\n"
                                "Texture2D map : register(t1);\nSamplerState linear_map : register(s0);\n") +
                        schlick +
                        "float4 main(float3 n : NORMAL) : SV_Target {\n"
                        "    clip(n.x);\n"
                        "    return map.Sample(linear_map, n.xy) * F(0.04, dot(n, eye));\n}\n");
    write("named.hlsl", std::string("float main(float f0, float u) {\n") +
                            std::string(schlick).substr(std::string(schlick).find('\n') + 1));
    write("a.wgsl",
          "@group(0) @binding(0) var<uniform> eye: vec3<f32>;\n"
          "@group(0) @binding(1) var map: texture_2d<f32>;\n"
          "fn F(f0: f32, u: f32) -> f32 {\n    return f0 + (1.0 - f0) * pow(max(1.0 - u, 0.0), 5.0);\n}\n"
          "@fragment fn main(@location(0) n: vec3<f32>) -> @location(0) vec4<f32> {\n"
          "    return textureLoad(map, vec2<i32>(0, 0), 0) * F(0.04, dot(n, eye));\n}\n");
    expect_schlick("a.hlsl", "F");
    expect_schlick("named.hlsl", "main");
    expect_schlick("a.wgsl", "F");
}

TEST_F(conform, a_function_that_gives_only_NaN_has_no_errors_and_no_range) {
    write("a.glsl", "float F(float f0, float u) { return sqrt(-1.0 - f0 - u * u); }\n");
    const outcome result = run("conform a.glsl --function F --as schlick --exact --json");
    EXPECT_EQ(result.code, 1);
    const nlohmann::json report = nlohmann::json::parse(result.out);
    for (const char* key : {"max_error", "max_relative_error", "rms_error", "lowest", "highest",
                            "exact_max_error", "exact_rms_error"})
        EXPECT_TRUE(report.at(key).is_null()) << key << " " << report[key];
    EXPECT_EQ(report["nan"], report["inputs"]);
    const std::string text = run("conform a.glsl --function F --as schlick").out;
    EXPECT_NE(text.find("largest error   none (none of the value), rms none"), std::string::npos) << text;
    EXPECT_NE(text.find("values          [none, none]"), std::string::npos) << text;
}

// ---- what is refused --------------------------------------------------------------------------------------

TEST_F(conform, refuses_what_it_cannot_use) {
    write("a.glsl", schlick);
    const std::string a = "conform a.glsl --function F --as schlick ";
    expect_refused("conform nowhere.glsl --function F --as schlick", {"nowhere.glsl", "no such file"});
    expect_refused("conform a.glsl --function G --as schlick", {"--function 'G'", "it defines F"});
    expect_refused("conform a.glsl --function F --as schlik", {"schlik", "did you mean 'schlick'"});
    expect_refused("conform a.glsl --function F --as f82", {"f82", "--fix f82=VALUE"});
    expect_refused(a + "--lang osl", {"--lang = 'osl'", "glsl, hlsl or wgsl"});
    expect_refused(a + "--args f0", {"--args", "1 expressions", "takes 2"});
    expect_refused(a + "--args 'f0, 1/('", {"--args '1/('"});
    expect_refused(a + "--args 'f0, theta'", {"'theta'", "it has f0"});
    expect_refused(a + "--args 'f0, normal'", {"'normal'", "is a direction", "'u'"});
    expect_refused(a + "--args '0.5, cos_i'", {"f0", "--fix f0=VALUE"});
    expect_refused(a + "--args 'f0, 0.5'", {"the angle"});
    expect_refused(a + "--fix f0=3", {"f0 = 3", "[0, 1]"});
    expect_refused(a + "--fix eta=3", {"--fix 'eta'", "no such parameter"});
    expect_refused(a + "--range f0=0", {"--range 'f0=0'", "PARAMETER=LOW,HIGH"});
    expect_refused(a + "--range f0=0.5,0.1", {"--range f0", "must rise"});
    expect_refused(a + "--tolerance -1", {"--tolerance: '-1' must be a number above 0"});
    write("a.txt", schlick);
    expect_refused("conform a.txt --function F --as schlick", {"a.txt", "--lang"});
    write("b.glsl", "vec4 F(float f0, float u) { return vec4(f0 + u); }\n");
    expect_refused("conform b.glsl --function F --as schlick",
                   {"vec4 F(float f0, float u)", "float or three"});
    write("c.glsl", "float F(float f0, int u) { return f0 + float(u); }\n");
    expect_refused("conform c.glsl --function F --as schlick", {"argument u is int"});
    write("d.glsl", "float F(float f0, float zzz) { return f0 + zzz; }\n");
    expect_refused("conform d.glsl --function F --as schlick", {"'zzz'", "give --args"});
}

TEST_F(conform, text_that_does_not_compile_is_refused_in_its_compiler_s_words) {
    const std::string c_like =
        "// a comment\nfloat F(float f0, float u) {\n    return f0 + undeclared * u;\n}\n";
    write("a.glsl", c_like);
    expect_refused("conform a.glsl --function F --as schlick", {"fresnel: a.glsl:3: ", "undeclared"});
    write("a.hlsl", c_like);
    expect_refused("conform a.hlsl --function F --as schlick",
                   {"fresnel: a.hlsl:3: ", "'undeclared' : unknown"});
    write("a.wgsl", "// a comment\nfn F(f0: f32, u: f32) -> f32 {\n    return f0 + undeclared * u;\n}\n");
    const outcome wgsl = run("conform a.wgsl --function F --as schlick");
    if (wgsl.err.find("cannot be run here") != std::string::npos) GTEST_SKIP() << "skipped: " << wgsl.err;
    expect_refused("conform a.wgsl --function F --as schlick", {"fresnel: a.wgsl:3: ", "undeclared"});
    write("b.wgsl", "fn F(f0: f32, u: f32) -> f32 {\n    return vec3f(f0 + u);\n}\n");
    expect_refused("conform b.wgsl --function F --as schlick",
                   {"fresnel: b.wgsl:1: ", "'F' is invalid: ", "does not match the declared return type"});
}

// scripts/setup installs one; FRESNEL_NAGA names another, which is called with the text and the file to write.
TEST_F(conform, the_compiler_of_WGSL_is_found_or_named) {
    write("a.wgsl",
          "fn F(f0: f32, u: f32) -> f32 {\n    return f0 + (1.0 - f0) * pow(max(1.0 - u, 0.0), 5.0);\n}\n");
    const std::string command = "conform a.wgsl --function F --as schlick";
    const outcome missing = run(command, "FRESNEL_NAGA=nowhere ");
    EXPECT_EQ(missing.code, 1);
    for (const char* piece :
         {"--lang wgsl: cannot be run here", "nowhere is not there", "scripts/setup", "FRESNEL_NAGA"})
        EXPECT_NE(missing.err.find(piece), std::string::npos) << missing.err;

    if (std::system("command -v fresnel-naga >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "skipped: no fresnel-naga";
    EXPECT_EQ(run(command).code, 0) << run(command).err;
    write("named", "#!/bin/sh\necho called >>called\nexec fresnel-naga \"$1\" \"$2\"\n");
    ASSERT_EQ(std::system(("chmod +x '" + (folder / "work/named").string() + "'").c_str()), 0);
    EXPECT_EQ(run(command, "FRESNEL_NAGA=./named ").code, 0);
    EXPECT_EQ(read_text(folder / "work/called").substr(0, 7), "called\n");
}

// ---- parts ------------------------------------------------------------------------------------------------

TEST(conform_signature, finds_definitions_and_their_arguments) {
    const std::string text = "// float F(float comment) {}\n"
                             "#define F(x) float F(float macro) {\n"
                             "float F(float u); /* float F(int a) { */\n"
                             "highp vec3 F(in vec3 f0,\n  const float u)\n{ return F(f0); }\n"
                             "half F(half3 v : NORMAL, out float t) { return G(v); }\n";
    const auto found = fresnel::conform::find_functions("glsl", text, "F");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].text("glsl", "F"), "vec3 F(vec3 f0, float u)");
    EXPECT_EQ(found[0].width, 3);
    EXPECT_EQ(found[0].line, 4);
    EXPECT_EQ(found[1].arguments[0].width, 3);
    EXPECT_TRUE(found[1].arguments[1].out);
    const auto wgsl = fresnel::conform::find_functions(
        "wgsl", "fn F(f0: vec3<f32>, u : f32,) -> vec3<f32> { return f0; }", "F");
    ASSERT_EQ(wgsl.size(), 1u);
    EXPECT_EQ(wgsl[0].text("wgsl", "F"), "fn F(f0: vec3<f32>, u: f32) -> vec3<f32>");
}

TEST(conform_binding, knows_the_names_that_functions_use) {
    struct {
        const char *text, *model, *bound;
    } const cases[] = {
        {"vec3 F(vec3 f0, float u) {}", "schlick", "f0 cos_i"},
        {"vec3 F(float cosTheta, vec3 F0) {}", "schlick", "cos_i f0"},
        {"vec3 F(vec3 SpecularColor, float VoH) {}", "schlick", "f0 cos_i"},
        {"float F(vec3 n, vec3 v, float f0) {}", "schlick", "normal direction f0"},
        {"float F(vec3 V, vec3 H, float f0) {}", "schlick", "direction normal f0"},
        {"float F(vec3 I, vec3 N, float ior) {}", "dielectric", "-direction normal eta"},
        {"float F(float cosi, float ior) {}", "dielectric", "cos_i eta"},
        {"float F(float cos_theta_i, float inv_eta) {}", "dielectric", "cos_i 1 / eta"},
        {"float F(float etaI, float etaT, float c) {}", "dielectric", "n_i n_t cos_i"},
        {"vec3 F(vec3 n, vec3 k, float u) {}", "conductor", "n k cos_i"},
        {"vec3 F(vec3 eta, vec3 k, float u) {}", "conductor", "eta k cos_i"},
        {"vec3 F(vec3 r, vec3 edge_tint, float u) {}", "gulbrandsen", "r g cos_i"},
        {"float F(float oneMinusVoH, float f0) {}", "schlick", "1 - cos_i f0"},
        {"vec3 F(vec3 F0, float F90, float VdotH) {}", "schlick_f90", "f0 f90 cos_i"},
    };
    for (const auto& c : cases) {
        fresnel::conform::conform_request request;
        request.language = "glsl", request.function = "F", request.text = c.text, request.model = c.model;
        const fresnel::conform::binding bound(request);
        std::string got;
        for (const auto& e : bound.expressions())
            got += (got.empty() ? "" : " ") + e.text();
        EXPECT_EQ(got, c.bound) << c.text;
    }
}

TEST(conform_expression, is_evaluated_as_it_reads) {
    const auto value = [](const char* text) {
        return fresnel::conform::expression_text("--args", text).evaluate([](const std::string& name) {
            return name == "a" ? 3.0 : 5.0;
        });
    };
    EXPECT_EQ(value("1.5f"), 1.5);
    EXPECT_EQ(value("-a + b * 2 - 1"), 6);
    EXPECT_EQ(value("1 - a - b"), -7);
    EXPECT_EQ(value("12 / a / 2"), 2);
    EXPECT_EQ(value("vec3((a + 1) * b)"), 20);
    EXPECT_EQ(value("sqrt(a + 1)"), 2);
    for (const char* bad : {"", "1 +", "(a", "a b", "vec3(a", "2a", "a,b", "sin(a)"})
        EXPECT_THROW(value(bad), bad_input) << bad;
}

TEST(conform_message, is_one_line_in_the_user_s_own_lines) {
    using fresnel::conform::compiler_message;
    EXPECT_EQ(compiler_message("a.glsl", "1\n2\n3\n", "0:2(5): error: `x' undeclared\n0:3(1): error: more\n"),
              "a.glsl:2: 'x' undeclared");
    EXPECT_EQ(
        compiler_message("a.hlsl", "1\n2\n", "shader.hlsl\nERROR: 0:1: 'y' : unknown\nERROR: 1 error\n"),
        "a.hlsl:1: 'y' : unknown");
    EXPECT_EQ(compiler_message("a.glsl", "1\n", "0:9(5): error: no matching function\n"),
              "a.glsl: its end, or the call of its function: no matching function");
    EXPECT_EQ(compiler_message(
                  "a.wgsl", "1\n",
                  "error: Function [0] 'F' is invalid\n  ┌─ wgsl:1:1\n  = An expression\n  = Not so\n"),
              "a.wgsl:1: Function [0] 'F' is invalid: An expression: Not so");
    EXPECT_EQ(compiler_message("a.wgsl", "1\n", "\nsomething else\n"),
              "a.wgsl: its compiler refuses it: something else");
}

} // namespace
} // namespace fresnel::test
