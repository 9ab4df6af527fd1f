// `fresnel shader` as a user runs it.

#include "command.hpp"
#include "shader_compilers.hpp"

#include <regex>
#include <sstream>

namespace fresnel::test {
namespace {

constexpr const char* language_names[] = {"glsl", "essl", "hlsl", "msl", "wgsl", "osl", "cuda", "c", "slang"};

class shader : public command_test {
protected:
    std::string text(const std::string& arguments) const {
        const outcome result = run("shader " + arguments);
        EXPECT_EQ(result.code, 0) << arguments << "\n" << result.err;
        return result.out;
    }

    /// Whether it is all right, by a compiler that reads it from standard input.
    bool compiles(const std::string& compiler, const std::string& source) const {
        write("source", source);
        const std::string line = compiler + " <'" + (folder / "work/source").string() + "' >/dev/null 2>&1";
        return std::system(line.c_str()) == 0;
    }
};

constexpr const char* c_compiler = "cc -std=gnu11 -Wall -Werror -Wno-unused-function -fsyntax-only -x c -";
constexpr const char* glsl_compiler = "glslangValidator --stdin -S frag";

std::string fragment_shader(const std::string& glsl) { return "#version 330\n" + glsl + "void main() {}\n"; }

std::string without_comments(const std::string& text) {
    return std::regex_replace("\n" + text, std::regex("\n? *//[^\n]*"), "");
}

void expect_holds(const std::string& text, const std::string& piece) {
    EXPECT_NE(text.find(piece), std::string::npos) << "lacks: " << piece << "\n" << text;
}

TEST_F(shader, prints_schlick_as_a_person_would_write_it) {
    const std::string glsl = text("schlick --lang glsl");
    expect_holds(glsl, "float schlick(float f0, float cos_i) {\n"
                       "    float x = 1.0 - cos_i;\n"
                       "    float x2 = x * x;\n"
                       "    return f0 + (1.0 - f0) * (x2 * x2 * x);\n"
                       "}\n");
    expect_holds(glsl, "vec3 schlick(vec3 f0, float cos_i) {\n");
    expect_holds(glsl, "vec3 schlick(vec3 f0, vec3 normal, vec3 direction) {\n");
    expect_holds(text("schlick --lang wgsl"), "fn schlick_rgb(f0: vec3f, cos_i: f32) -> vec3f {\n"
                                              "    let x = 1.0 - cos_i;\n"
                                              "    let x2 = x * x;\n"
                                              "    return f0 + (1.0 - f0) * (x2 * x2 * x);\n"
                                              "}\n");
    expect_holds(text("schlick --lang c"), "static inline float schlick(float f0, float cos_i) {\n"
                                           "    const float x = 1.0f - cos_i;\n");
}

TEST_F(shader, two_texts_pasted_into_one_file_keep_both_functions) {
    for (const char* language : {"glsl", "essl", "hlsl", "msl", "osl", "cuda", "c", "slang"})
        for (const char* model : {"schlick", "f82"}) {
            const std::string printed = text(std::string(model) + " --lang " + language);
            const std::size_t types = printed.rfind("#endif\n");
            EXPECT_LT(types, printed.find(std::string("float ") + model + "(")) << language;
        }
}

TEST_F(shader, a_module_of_WGSL_takes_one_text_and_is_told_so) {
    const std::string said = "// A module takes one such text";
    for (const char* language : language_names)
        EXPECT_EQ(text(std::string("schlick f82 --lang ") + language).find(said) != std::string::npos,
                  std::string(language) == "wgsl");
    expect_holds(text("--all --lang wgsl"), said);
    if (!has_command("fresnel-naga")) GTEST_SKIP() << "skipped: no fresnel-naga";
    const std::string naga =
        "cd '" + (folder / "work").string() + "' && fresnel-naga --bulk-validate *.wgsl >log 2>&1";
    write("t.wgsl", text("schlick f82 --lang wgsl"));
    EXPECT_EQ(std::system(naga.c_str()), 0);
    write("t.wgsl", text("schlick --lang wgsl") + text("f82 --lang wgsl"));
    EXPECT_NE(std::system(naga.c_str()), 0);
}

TEST_F(shader, says_above_each_function_what_it_is_and_where_from) {
    const std::string hlsl = text("f82 --lang hlsl");
    for (const char* piece :
         {"// f0      reflectance at normal incidence, [0, 1]", "// cos_i   cosine of incidence, [0, 1]",
          "// error   at most 0.0406, certified for", "// cost    ", "// source  Hoffman 2019"})
        expect_holds(hlsl, piece);
    expect_holds(hlsl, "point away from the surface");
    expect_holds(text("conductor"), "up to 1e-1 at a critical angle of small k_t\n");
}

TEST_F(shader, library_of_every_language_holds_every_model) {
    const nlohmann::json models = json("models --json");
    for (const char* language : language_names) {
        const std::string library = text(std::string("--all --lang ") + language);
        for (const nlohmann::json& model : models) {
            std::string name = " " + model["name"].get<std::string>();
            if (model["kind"] == "exact") expect_holds(library, name + "_boundary(");
            if (name == " constant" && std::string(language) == "msl") name += "_"; // an address space there
            expect_holds(library, name + "(");
        }
        for (const char* helper : {"incidence_cosine(", "reflected_direction(", "refracted_direction(",
                                   "critical_cosine(", "f0_from_eta(", "eta_from_f0("})
            expect_holds(library, helper);
    }
}

TEST_F(shader, library_of_every_language_has_short_lines_and_no_numbered_temporaries) {
    const std::regex temporary(R"(\bt_[0-9]+\b)");
    for (const char* language : language_names) {
        std::istringstream library(text(std::string("--all --lang ") + language));
        for (std::string line; std::getline(library, line);) {
            EXPECT_LE(line.size(), 120u) << language << ": " << line;
            EXPECT_FALSE(std::regex_search(line, temporary)) << language << ": " << line;
        }
    }
}

TEST_F(shader, compensated_arithmetic_is_called_and_printed_once) {
    for (const char* language : language_names)
        for (const char* arguments : {"conductor_precise", "conductor_precise --fix n_i=1", "--all"}) {
            const std::string printed = text(std::string(arguments) + " --lang " + language);
            expect_holds(printed, " = two_product(n_t, n_t);\n");
            const std::regex definition("two_sum\\([^)]*\\)( -> vec2f)? \\{");
            EXPECT_EQ(std::distance(std::sregex_iterator(printed.begin(), printed.end(), definition), {}), 1)
                << language << " " << arguments;
        }
    EXPECT_EQ(text("schlick --lang glsl").find("two_sum"), std::string::npos);
}

TEST_F(shader, no_variable_hides_the_function_that_makes_it) {
    const std::regex hidden(R"(\b(\w+) = \1\()");
    for (const char* language : language_names)
        for (const char* fixed : {"k_t=1,2,3", "n_t=1.5,0.5,2", "n_i=1,1.1,1.2", "k_t=1"}) {
            const std::string printed =
                text(std::string("conductor_precise --fix ") + fixed + " --lang " + language);
            EXPECT_FALSE(std::regex_search(printed, hidden)) << language << " " << fixed << "\n" << printed;
        }
    const std::string rgb = "conductor_precise --fix k_t=1,2,3";
    EXPECT_TRUE(compiles(c_compiler, text(rgb + " --lang c")));
    if (has_command("glslangValidator")) {
        EXPECT_TRUE(compiles(glsl_compiler, fragment_shader(text(rgb + " --lang glsl"))));
    }
}

TEST_F(shader, a_library_and_a_text_that_share_helpers_share_a_file) {
    for (const char* language : {"glsl", "essl", "hlsl", "msl", "osl", "cuda", "c", "slang"}) {
        const std::string lang = std::string(" --lang ") + language;
        const std::string library = text("--all" + lang);
        const std::string one = text("conductor_precise --fix n_i=1.333 --name wet" + lang);
        for (const std::string& printed : {library, one}) {
            const std::regex guarded("#ifndef (FRESNEL_[A-Z]+_TWOFOLD)\n#define \\1\n");
            std::smatch guard;
            ASSERT_TRUE(std::regex_search(printed, guard, guarded)) << language;
            const std::size_t begin = static_cast<std::size_t>(guard.position());
            for (const char* helper : {"two_sum(", "twofold_product("}) {
                EXPECT_LT(begin, printed.find(helper)) << language;
                EXPECT_LT(printed.find(helper), printed.find("#endif\n", begin)) << language;
            }
        }
        for (const std::string& both : {library + one, one + library}) {
            if (lang == " --lang c") {
                EXPECT_TRUE(compiles(c_compiler, both));
            } else if (lang == " --lang glsl" && has_command("glslangValidator")) {
                EXPECT_TRUE(compiles(glsl_compiler, fragment_shader(both)));
            }
        }
    }
}

TEST_F(shader, fixed_parameters_are_gone_and_folded) {
    const std::string glsl = text("schlick --fix f0=0.04");
    expect_holds(glsl, "float schlick(float cos_i) {\n");
    expect_holds(glsl, "return 0.04 + 0.96 * (x2 * x2 * x);\n");
    expect_holds(text("dielectric --fix n_i=1"), "float dielectric(float n_t, float cos_i) {\n");
    expect_holds(text("schlick --fix f0=1,0.78,0.34"), "vec3 f0 = vec3(1.0, 0.78, 0.34);\n");
}

TEST_F(shader, error_is_said_of_constants_that_it_was_taken_over) {
    for (const char* arguments :
         {"schlick --fix f0=0.04", "schlick_f90 --fix f90=1", "schlick_internal --fix eta=0.75",
          "schlick_nk --fix n=0.2 --fix k=3", "hoffman"})
        expect_holds(text(arguments), "// error   at most ");
    for (const char* arguments : {"dielectric --fix n_i=1.333", "conductor --fix k_t=0"})
        expect_holds(text(arguments), "// error   rounding only, ");
    for (const char* arguments :
         {"schlick --fix f0=0.9", "schlick_f90 --fix f90=0", "schlick_f90 --fix f90=1,1,0.9",
          "schlick_internal --fix eta=0.99", "schlick_nk --fix k=0", "hoffman --fix power=0.1",
          "f82 --fix f0=0.9 --fix f82=1"})
        expect_holds(text(arguments), "// error   not known for these constants\n");
}

TEST_F(shader, ends_of_a_range_can_be_fixed) {
    text("dielectric --fix n_i=0.01");
    text("schlick_internal --fix eta=0.01");
    EXPECT_EQ(run("lut dielectric --fix n_i=0.01 --fix n_t=0.001").code, 0);
    expect_refused("shader dielectric --fix n_i=0.0099999999", {"n_i = 0.0099999999", "[0.01, 100]"});
    expect_refused("shader schlick --fix f0=1.00000001", {"f0 = 1.00000001", "[0, 1]"});
    expect_refused("lut dielectric --fix n_i=100.000001", {"n_i = 100.000001", "[0.01, 100]"});
}

// In the equations above a function c is cos_i.
TEST_F(shader, folded_constants_are_not_called_c) {
    expect_holds(text("schlick --fix f0=1,0.75,0.25"), "vec3 one_minus_f0 = vec3(0.0, 0.25, 0.75);\n");
    expect_holds(text("lazanyi --material gold"), "    vec3 folded = vec3(");
    for (const char* model : {"schlick", "f82", "f82_tint", "lazanyi", "hoffman", "gulbrandsen"}) {
        const std::string printed = text(std::string(model) + " --material gold");
        EXPECT_EQ(printed.find(" c = vec3("), std::string::npos) << printed;
        EXPECT_EQ(printed.find(" c_2 = vec3("), std::string::npos) << printed;
    }
}

TEST_F(shader, every_equation_says_what_it_is_of) {
    for (const char* model : {"f82", "hoffman", "powers_4_12", "powers_2_8_16"})
        expect_holds(text(model), "//   F = f0 + ");
}

TEST_F(shader, the_boundary_s_type_is_printed_where_it_is_used) {
    for (const char* language : language_names) {
        const std::string lang = std::string(" --lang ") + language;
        EXPECT_EQ(text("f82" + lang).find("fresnel_boundary"), std::string::npos) << language;
        for (const char* arguments : {"dielectric", "f82 conductor", "--all"})
            for (const char* piece : {"// reflected, polarised across and along", "// transmitted"})
                expect_holds(text(arguments + lang), piece);
    }
}

TEST_F(shader, long_comments_are_wrapped_and_commands_are_not) {
    const std::string glsl = text("gulbrandsen --material gold --space acescg --name gold");
    expect_holds(glsl, "// data    gold, fitted in linear ACEScg; P. B. Johnson and R. W. Christy.");
    std::istringstream lines(glsl);
    for (std::string line; std::getline(lines, line);)
        EXPECT_TRUE(line.size() <= 120 || line.find('`') != std::string::npos) << line;
}

TEST_F(shader, material_gives_constants_with_their_source) {
    const std::string glsl = text("schlick --material gold --space acescg --name gold");
    expect_holds(glsl, "vec3 gold(float cos_i) {\n");
    expect_holds(glsl, "// data    gold, fitted in linear ACEScg; P. B. Johnson and R. W. Christy");
    expect_holds(text("schlick --material gold --ambient 1.333"),
                 "// data    gold, fitted in linear sRGB, ambient 1.333; P. B. Johnson");
    const nlohmann::json f0 = json("f0 gold --json --space acescg")["f0"];
    std::string expected = "vec3 f0 = vec3(";
    expect_holds(glsl, expected);
    const std::size_t at = glsl.find(expected) + expected.size();
    EXPECT_NEAR(std::stod(glsl.substr(at)), f0[0].get<double>(), 1e-6);
}

TEST_F(shader, the_command_in_a_text_makes_it_again) {
    write("it's a metal.csv", "wavelength_nm,n,k\n380,0.2,3\n780,0.1,4\n");
    for (const char* arguments :
         {"schlick f82 --lang wgsl --fix f0=0.04", "schlick --material \"it's a metal.csv\"",
          "gulbrandsen --material gold --space acescg --ambient 1.333",
          "schlick --material gold --ambient 1.333 --technique per-pixel --lang glsl --stage fragment",
          "schlick --technique lut --stage vertex --name mine"}) {
        const std::string printed = text(arguments);
        const std::string made_by = "Made by `fresnel shader ";
        const std::size_t begin = printed.find(made_by) + made_by.size();
        EXPECT_EQ(text(printed.substr(begin, printed.find('`', begin) - begin)), printed) << arguments;
    }
}

TEST_F(shader, hostile_file_names_stay_in_comments) {
    const std::string metal = "wavelength_nm,n,k\n380,0.2,3\n780,0.1,4\n";
    write("metal.csv", metal);
    std::filesystem::create_directories(folder / "work/*");
    const std::string broken = std::string(100, 'a') + "\\ where a line is broken.csv";
    for (const std::string& name : {std::string("a\nint x;.csv"), std::string("*/ int x;.csv"), broken}) {
        write(name, metal);
        for (const std::string how :
             {" --lang c", " --lang wgsl", " --lang glsl --technique lut --stage fragment"})
            EXPECT_EQ(without_comments(text("schlick --material '" + name + "'" + how)),
                      without_comments(text("schlick --material metal.csv" + how)))
                << name;
    }
}

TEST_F(shader, hostile_names_are_made_legal_and_said) {
    const outcome result = run("shader schlick --lang glsl --name mix");
    EXPECT_EQ(result.code, 0);
    expect_holds(result.out, "float mix_(float f0, float cos_i)");
    expect_holds(result.err, "the function is called mix_");
    for (const char* language : {"c", "cuda"})
        for (const std::string macro : {"linux", "unix"})
            expect_holds(text("schlick --lang " + std::string(language) + " --name " + macro),
                         " " + macro + "_(");
}

TEST_F(shader, out_writes_one_file_and_nothing_beside_it) {
    text("schlick --lang hlsl --out a.hlsl");
    EXPECT_EQ(files(), std::vector<std::string>{"a.hlsl"});
    EXPECT_EQ(read_text(folder / "work" / "a.hlsl"), text("schlick --lang hlsl"));
}

TEST_F(shader, written_packs_are_what_check_expects_until_one_is_touched) {
    text("--write packs");
    EXPECT_EQ(run("shader --check packs").code, 0);
    std::ofstream(folder / "work/packs/glsl/fresnel.glsl", std::ios::app) << "// mine\n";
    outcome result = run("shader --check packs");
    EXPECT_EQ(result.code, 1);
    expect_holds(result.out, "glsl/fresnel.glsl differs");
    std::filesystem::remove(folder / "work/packs/c/fresnel.h");
    expect_holds(run("shader --check packs").out, "c/fresnel.h is missing");
    write("packs/glsl/own.glsl", "");
    expect_holds(run("shader --check packs").out, "glsl/own.glsl is not generated");
}

TEST_F(shader, checked_in_packs_are_what_the_generator_makes) {
    const outcome result = run("shader --check '" FRESNEL_SOURCE_DIR "/shaders'");
    EXPECT_EQ(result.code, 0) << result.out << "run: fresnel shader --write shaders";
}

TEST_F(shader, bad_input_is_refused_by_name) {
    expect_refused("shader", {"MODEL", "--all"});
    expect_refused("shader schlik", {"schlik", "schlick"});
    expect_refused("shader schlick --lang glsll", {"--lang", "glsll", "did you mean 'glsl'", "wgsl"});
    expect_refused("shader schlick --fix f1=0.04", {"f1", "schlick", "f0"});
    expect_refused("shader schlick --fix f0=2", {"f0", "2", "[0, 1]"});
    expect_refused("shader schlick --fix f0=red", {"f0", "red", "number"});
    expect_refused("shader schlick --fix f0=1,2", {"f0=1,2", "1 or 3"});
    expect_refused("shader schlick --fix f0", {"PARAMETER=VALUE"});
    expect_refused("shader conductor --material gold", {"--material", "conductor", "gulbrandsen"});
    expect_refused("shader schlick --material unobtainium", {"unobtainium"});
    expect_refused("shader schlick f82 --name mine", {"--name", "mine", "2"});
    expect_refused("shader schlick --all", {"--all"});
    expect_refused("shader schlick f82 schlick", {"MODEL 'schlick'", "twice"});
    expect_refused("shader schlick --material glass --fix f0=0.9",
                   {"--fix 'f0=0.9'", "--material 'glass'", "leave one of them out"});
    expect_refused("shader schlick --material glass --fix f1=0.9", {"f1", "schlick", "f0"});
    for (const std::string option : {"--material", "--name", "--technique", "--stage", "--out"})
        expect_refused("shader schlick " + option + " ''", {option + ": must not be ''"});
    for (const std::string option : {"--write", "--check", "--verify --dump", "--verify --compare"})
        expect_refused("shader " + option + " ''", {option.substr(option.rfind('-') - 1), "must not be ''"});
    expect_refused("shader --check nowhere", {"--check", "nowhere"});
}

TEST_F(shader, an_option_that_nothing_takes_is_refused) {
    expect_refused("shader dielectric --ambient 1.333", {"--ambient 1.333", "--material", "--fix n_i=1.333"});
    expect_refused("shader schlick --space acescg", {"--space acescg", "--material", "--fix"});
    expect_refused("shader --all --fix f0=0.04", {"--fix 'f0=0.04'", "--all", "MODEL"});
    expect_refused("shader --all --material gold", {"--material 'gold'", "--all", "MODEL"});
    expect_refused("shader --write packs --lang hlsl", {"--write", "--lang"});
    expect_refused("shader --write packs --check packs", {"--write", "--check"});
    expect_refused("shader --check packs schlick", {"--check", "MODEL"});
    expect_refused("shader --verify schlick --space p3", {"--verify", "--space"});
}

TEST_F(shader, a_folder_that_cannot_be_written_is_refused_by_name) {
    write("file", "");
    expect_refused("shader schlick --out file/a.glsl", {"--out", "file/a.glsl"});
    for (const std::string to : {"file", "file/x", "/proc/x"}) {
        expect_refused("shader --write " + to, {"--write '" + to + "': must be a folder"});
        expect_refused("shader --verify schlick --dump " + to, {"--dump '" + to + "': must be a folder"});
    }
}

} // namespace
} // namespace fresnel::test
