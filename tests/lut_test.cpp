// Tables: where their texels stand, that the claimed errors are the measured ones, and that the printed functions read
// them as they were measured, in C by running it and in GLSL on a software rasteriser.

#include "command.hpp"
#include "texture_device.hpp"
#include "tolerances.hpp"

#include "analysis/curve.hpp"
#include "emit/lut_study.hpp"
#include "emit/lut_text.hpp"
#include "emit/technique.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <half.h>
#include <png.h>

#include <cmath>
#include <random>

namespace {

using namespace fresnel;
using namespace fresnel::emit;

fixed_values one(const std::string& name, double value) { return {{name, {value, value, value}}}; }

lut_subject glass() { return model_subject("dielectric", one("n_t", 1.5)); }

lut_subject inside_glass() {
    return model_subject("dielectric", {{"n_i", {1.5, 1.5, 1.5}}, {"n_t", {1, 1, 1}}});
}

lut_subject gold(color_space space = color_space::acescg) {
    return material_subject(*find_material("gold"), space, 1);
}

lut baked(const lut_subject& subject, std::size_t size, std::string_view map,
          texel_format format = texel_format::rgba32f) {
    return bake(subject, {map, size, size, format});
}

// ---- where the texels stand -----------------------------------------------------------------------------------

TEST(lut, maps_are_inverted_and_keep_the_ends) {
    for (const lut_map& map : lut_maps()) {
        EXPECT_EQ(map.coordinate(0), 0) << map.name;
        EXPECT_EQ(map.coordinate(1), 1) << map.name;
        EXPECT_EQ(map.cosine(0), 0) << map.name;
        EXPECT_NEAR(map.cosine(1), 1, 1e-15) << map.name;
        for (int i = 0; i <= 100; ++i)
            EXPECT_NEAR(double(map.coordinate(static_cast<float>(map.cosine(i / 100.0)))), i / 100.0, 2e-6)
                << map.name;
    }
}

TEST(lut, grazing_and_normal_incidence_are_texel_centres) {
    for (const lut_subject& subject : {glass(), gold(), inside_glass()})
        for (const std::size_t size : {2u, 3u, 32u, 100u, 4096u}) {
            const lut table = baked(subject, size, "sqrt-cos");
            const std::vector<rgb> exact = subject.reflectance({0, 1}, 0);
            for (std::size_t c = 0; c < table.channels(); ++c) {
                EXPECT_NEAR(double(sample(table, 0)[c]), exact[0][c], 1e-6) << subject.caption << size;
                EXPECT_NEAR(double(sample(table, 1)[c]), exact[1][c], 1e-6) << subject.caption << size;
            }
        }
}

TEST(lut, texels_are_numbers_of_their_format) {
    for (const texel_format format : {texel_format::r8, texel_format::r16, texel_format::r16f}) {
        const lut table = baked(glass(), 64, "cos", format);
        const lut exact = baked(glass(), 64, "cos");
        for (std::size_t i = 0; i < table.texels.size(); ++i) {
            const float texel = table.texels[i];
            const double steps = format == texel_format::r8 ? 255 : 65535;
            if (format == texel_format::r16f) {
                EXPECT_EQ(texel, float{Imath::half(texel)});
            } else {
                EXPECT_NEAR(double(texel) * steps, std::round(double(texel) * steps), 0.01);
            }
            EXPECT_NEAR(double(texel), double(exact.texels[i]),
                        format == texel_format::r8 ? 0.00197 : 0.00025);
        }
    }
}

TEST(lut, a_colour_above_one_is_scaled_into_eight_bits) {
    const lut table = baked(gold(color_space::srgb), 64, "sqrt-cos", texel_format::r8);
    EXPECT_EQ(table.lo, 0);
    EXPECT_NEAR(table.hi, 1.038, 1e-9) << "the red of gold at normal incidence is 1.0376";
    EXPECT_LT(table.error.max, 0.0022);
    EXPECT_FALSE(baked(gold(), 64, "sqrt-cos", texel_format::r8).scaled()) << "ACEScg holds it";
}

// ---- errors -----------------------------------------------------------------------------------------------------

// The largest error by other means: a position among the texels in double, at random cosines.
double independent_error(const lut& table, std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(0, 1);
    const double from = table.subject.critical;
    double most = 0;
    for (std::size_t n = 0; n < count; ++n) {
        const double t = any(random), c = from + (1 - from) * table.map->cosine(t);
        const double x = t * static_cast<double>(table.columns - 1);
        const auto i = std::min(static_cast<std::size_t>(x), table.columns - 2);
        const double w = x - static_cast<double>(i);
        const rgb exact = table.subject.reflectance({c}, 0).front();
        for (std::size_t k = 0; k < table.channels(); ++k) {
            const double a = double(table.texels[i * table.channels() + k]),
                         b = double(table.texels[(i + 1) * table.channels() + k]);
            most = std::max(most, std::abs(table.lo + (table.hi - table.lo) * (a + (b - a) * w) - exact[k]));
        }
    }
    return most;
}

TEST(lut, the_claimed_error_is_found_at_random_cosines) {
    for (const lut_subject& subject : {glass(), inside_glass(), model_subject("schlick", {})})
        for (const texel_format format : {texel_format::r8, texel_format::r16f, texel_format::c})
            for (const std::size_t size : {16u, 64u}) {
                const lut table = baked(subject, size, "sqrt-cos", format);
                const double found = independent_error(table, 40000);
                // near a critical cosine its rounding to float moves the curve
                EXPECT_LE(found, table.error.max * 1.04) << subject.caption << to_string(format) << size;
                EXPECT_GE(found, table.error.max * 0.95) << subject.caption << to_string(format) << size;
            }
}

TEST(lut, a_wrong_texel_shows_in_the_error) {
    lut table = baked(glass(), 64, "sqrt-cos");
    const double before = table.error.max;
    table.texels[40] += 0.01f;
    EXPECT_GT(error_of(table).max, 0.009);
    EXPECT_LT(before, 0.0005);
}

struct published {
    std::string_view map;
    std::vector<double> error; ///< of 16, 32, 64 and 256 texels
};

void expect_published(const lut_subject& subject, const std::vector<published>& all) {
    for (const lut_study_row& row : study_lut(subject, {16, 32, 64, 256})) {
        if (row.format != texel_format::rgba32f) continue;
        for (const published& p : all) {
            if (p.map != row.map->name) continue;
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(row.error[i].max, p.error[i], 0.06 * p.error[i]) << p.map << " " << i;
        }
    }
}

TEST(lut, errors_fall_with_the_square_of_the_size_but_for_a_root) {
    expect_published(glass(), {{"cos", {0.017, 0.0045, 0.00115, 7.3e-5}},
                               {"sqrt-cos", {0.0063, 0.0015, 0.00037, 2.2e-5}},
                               {"angle", {0.037, 0.0103, 0.0027, 1.8e-4}},
                               {"sine", {0.42, 0.32, 0.24, 0.126}}});
    expect_published(inside_glass(),
                     {{"cos", {0.34, 0.31, 0.23, 0.13}}, {"sqrt-cos", {0.0149, 0.0038, 0.00095, 8.9e-5}}});
}

TEST(lut, eight_bits_end_at_half_a_step) {
    EXPECT_NEAR(baked(glass(), 64, "sqrt-cos", texel_format::r8).error.max, 1 / 510.0, 2e-5);
    EXPECT_NEAR(baked(glass(), 1024, "cos", texel_format::r8).error.max, 1 / 510.0, 2e-5);
    EXPECT_LT(baked(glass(), 32, "sqrt-cos", texel_format::r8).error.max, 1.35 / 510);
    EXPECT_GT(baked(glass(), 32, "cos", texel_format::r8).error.max, 2.2 / 510);
}

TEST(lut, weights_of_eight_bits_cost_little_more) {
    const lut table = baked(glass(), 64, "sqrt-cos");
    EXPECT_GT(table.error.max_8_bit, table.error.max);
    EXPECT_LT(table.error.max_8_bit, table.error.max + 0.0003);
    const lut array = baked(glass(), 64, "sqrt-cos", texel_format::c);
    EXPECT_EQ(array.error.max_8_bit, array.error.max) << "an array has no filter";
}

TEST(lut, auto_takes_the_map_with_the_smaller_error) {
    for (const std::size_t size : {8u, 64u})
        for (const lut_subject& subject : {glass(), gold(), model_subject("one_minus_cos", {})}) {
            const lut chosen = bake(subject, {std::nullopt, size, 1, texel_format::rgba32f});
            EXPECT_EQ(chosen.error.max, std::min(baked(subject, size, "cos").error.max,
                                                 baked(subject, size, "sqrt-cos").error.max));
        }
    EXPECT_EQ(bake(glass(), {}).map->name, "sqrt-cos");
    EXPECT_EQ(bake(model_subject("one_minus_cos", {}), {}).map->name, "cos") << "a straight line";
}

TEST(lut, a_constant_and_a_line_have_no_error) {
    EXPECT_LT(baked(model_subject("one_minus_cos", {}), 2, "cos").error.max, 1e-7);
    EXPECT_LT(baked(model_subject("constant", {}), 2, "sqrt-cos").error.max, 1e-7);
}

// ---- the critical angle -------------------------------------------------------------------------------------------

TEST(lut, below_the_critical_cosine_everything_is_reflected) {
    for (const texel_format format : {texel_format::r8, texel_format::rgba32f}) {
        const lut table = baked(inside_glass(), 32, "sqrt-cos", format);
        EXPECT_NEAR(table.subject.critical, std::sqrt(5.0) / 3, 1e-12);
        for (const float c : {0.0f, 0.1f, 0.5f, 0.745f, 0.7453f})
            EXPECT_EQ(sample(table, c)[0], 1) << c;
        EXPECT_LT(table.error.at_critical, 0.002) << "next to it a float's rounding counts";
        EXPECT_GT(table.error.at_critical, 0);
    }
}

TEST(lut, a_material_seen_from_inside_needs_one_critical_angle) {
    EXPECT_THROW(material_subject(*find_material("n-bk7"), color_space::srgb, 2), bad_input);
    EXPECT_GT(material_subject(*find_material("gems"), color_space::srgb, 2.5).critical, 0)
        << "a table row has one index";
    EXPECT_EQ(material_subject(*find_material("silver"), color_space::srgb, 1).critical, 0)
        << "n below 1, but it absorbs";
}

// ---- two axes -----------------------------------------------------------------------------------------------------

TEST(lut, a_second_axis_runs_over_the_index) {
    const lut table =
        bake(model_subject("dielectric", {}, "eta=1.2:2.5"), {{}, 64, 32, texel_format::rgba32f});
    std::mt19937 random(3);
    std::uniform_real_distribution<float> cosine(0, 1), index(1.2f, 2.5f);
    double most = 0;
    for (int n = 0; n < 100000; ++n) {
        const float c = cosine(random), eta = index(random);
        most = std::max(most, std::abs(double(sample(table, c, eta)[0]) -
                                       dielectric(1.0, double(eta), double(c)).reflectance()));
    }
    EXPECT_LE(most, table.error.max * 1.01);
    EXPECT_GE(most, table.error.max * 0.7) << "uniform cosines miss grazing incidence";
    EXPECT_NEAR(double(sample(table, 1, 1.2f)[0]), std::pow(0.2 / 2.2, 2), 1e-6);
    EXPECT_NEAR(double(sample(table, 1, 2.5f)[0]), std::pow(1.5 / 3.5, 2), 1e-6);
}

TEST(lut, an_exact_model_over_f0_is_the_index_of_that_f0) {
    const lut table =
        bake(model_subject("dielectric", {}, "f0=0.02:0.2"), {{}, 64, 64, texel_format::rgba32f});
    for (const float f0 : {0.02f, 0.04f, 0.11f, 0.2f})
        EXPECT_NEAR(double(sample(table, 1, f0)[0]), double(f0), 1e-5);
    EXPECT_LT(table.error.max, 0.001);
}

TEST(lut, a_model_linear_in_f0_needs_two_rows) {
    const lut_subject subject = model_subject("schlick", {}, "f0");
    const auto error = [&](std::size_t rows) {
        return bake(subject, {"sqrt-cos", 64, rows, texel_format::rgba32f}).error.max;
    };
    EXPECT_NEAR(error(2), error(64), 1e-6);
}

// ---- files --------------------------------------------------------------------------------------------------------

// Integers of a PNG, and how many channels it has.
std::vector<unsigned> read_png(const std::string& path, png_byte& depth, std::size_t& channels) {
    FILE* file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    depth = png_get_bit_depth(png, info), channels = png_get_channels(png, info);
    std::vector<unsigned> codes;
    for (png_uint_32 y = 0; y < png_get_image_height(png, info); ++y) {
        const png_byte* row = png_get_rows(png, info)[y];
        for (std::size_t i = 0; i < png_get_image_width(png, info) * channels; ++i)
            codes.push_back(depth == 16 ? 256u * row[2 * i] + row[2 * i + 1] : row[i]);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return codes;
}

std::vector<float> read_exr(const std::string& path, const std::string& channel, Imf::PixelType& type) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1),
               height = static_cast<std::size_t>(window.max.y + 1);
    const Imf::Channel* found = file.header().channels().findChannel(channel);
    if (found == nullptr) return {};
    type = found->type;
    std::vector<float> values(width * height);
    Imf::FrameBuffer buffer;
    buffer.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                      sizeof(float) * width));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

class lut_command : public test::command_test {
protected:
    std::string path(const std::string& name) const { return (folder / "work" / name).string(); }
    std::vector<float> texels(const std::string& arguments) const {
        return json("lut " + arguments + " --json")["texels"];
    }
};

TEST_F(lut_command, a_png_holds_the_texels) {
    for (const std::string format : {"r8", "r16"})
        for (const std::string what :
             {"dielectric", "gold --space acescg", "dielectric --by eta --size 16x8"}) {
            const std::vector<float> wanted = texels(what + " --format " + format + " --out t.png");
            png_byte depth = 0;
            std::size_t channels = 0;
            const std::vector<unsigned> codes = read_png(path("t.png"), depth, channels);
            EXPECT_EQ(depth, format == "r8" ? 8 : 16);
            EXPECT_EQ(channels, what.starts_with("gold") ? 3u : 1u);
            ASSERT_EQ(codes.size(), wanted.size()) << what;
            for (std::size_t i = 0; i < codes.size(); ++i)
                EXPECT_EQ(static_cast<float>(codes[i] / (depth == 8 ? 255.0 : 65535.0)), wanted[i]);
        }
}

TEST_F(lut_command, an_exr_holds_the_texels) {
    Imf::PixelType type = Imf::UINT;
    const std::vector<float> halves = texels("dielectric --format r16f --by f0 --size 16x8 --out t.exr");
    EXPECT_EQ(read_exr(path("t.exr"), "R", type), halves);
    EXPECT_EQ(type, Imf::HALF);
    EXPECT_TRUE(read_exr(path("t.exr"), "G", type).empty()) << "one channel";
    const std::vector<float> wanted = texels("gold --format rgba32f --size 8 --out t.exr");
    const std::array<std::string, 3> letters = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float> plane = read_exr(path("t.exr"), letters[c], type);
        ASSERT_EQ(plane.size(), 8u);
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_EQ(plane[i], wanted[3 * i + c]);
    }
    EXPECT_EQ(type, Imf::FLOAT);
    EXPECT_EQ(read_exr(path("t.exr"), "A", type), std::vector<float>(8, 1.0f));
}

TEST_F(lut_command, the_ending_chooses_the_format) {
    EXPECT_EQ(json("lut schlick --out t.png --json")["format"], "r8");
    EXPECT_EQ(json("lut schlick --out t.exr --json")["format"], "r16f");
    EXPECT_EQ(json("lut schlick --out t.h --json")["format"], "c");
    EXPECT_EQ(json("lut schlick --lang c --json")["format"], "c");
    EXPECT_EQ(files(), (std::vector<std::string>{"t.exr", "t.h", "t.png"}));
}

TEST_F(lut_command, json_says_what_was_baked) {
    const nlohmann::json table =
        json("lut dielectric --fix n_i=1.5 --fix n_t=1 --size 32 --format r16 --json");
    EXPECT_EQ(table["map"], "sqrt-cos");
    EXPECT_NEAR(table["critical_cosine"], std::sqrt(5.0) / 3, 1e-7);
    EXPECT_EQ(table["size"], (std::vector<int>{32, 1}));
    EXPECT_EQ(table["texels"].size(), 32u);
    EXPECT_NEAR(table["error"]["max"], 0.0038, 0.0002);
    EXPECT_NE(table["text"].get<std::string>().find("float dielectric_lut("), std::string::npos);
    const nlohmann::json errors = json("lut dielectric --errors --json");
    ASSERT_EQ(errors.size(), 64u) << "four maps, four formats, four sizes";
    EXPECT_EQ(errors[4 * 4 + 1]["map"], "sqrt-cos");
    EXPECT_NEAR(errors[4 * 4 + 1]["max"], 0.0025, 0.0001);
    const nlohmann::json two = json("lut schlick --by f0 --size 8x4 --json");
    EXPECT_EQ(two["by"]["range"], (std::vector<double>{0, 1}));
    EXPECT_EQ(two["texels"].size(), 32u);
}

TEST_F(lut_command, the_documentation_prints_what_the_command_does) {
    const std::string text = test::read_text(std::string(FRESNEL_SOURCE_DIR) + "/docs/lut.md");
    std::size_t found = 0;
    for (std::size_t at = text.find("$ fresnel "); at != std::string::npos;
         at = text.find("$ fresnel ", at), ++found) {
        const std::size_t line = text.find('\n', at), end = text.find("```", line);
        const std::string arguments = text.substr(at + 10, line - at - 10);
        EXPECT_EQ(run(arguments).out, text.substr(line + 1, end - line - 1)) << arguments;
        at = end;
    }
    EXPECT_GE(found, 7u);
}

TEST_F(lut_command, the_figure_has_a_curve_for_each_map) {
    const nlohmann::json figure = nlohmann::json::parse([&] {
        EXPECT_EQ(run("lut dielectric --plot maps.json --plot maps.json").code, 2) << "one file";
        EXPECT_EQ(run("lut dielectric --plot maps.json").code, 0);
        return test::read_text(path("maps.json"));
    }());
    ASSERT_EQ(figure["series"].size(), 6u) << "four in floats, the two that are offered in bytes";
    EXPECT_EQ(figure["series"][0]["x_axis"]["logarithmic"], true);
    EXPECT_EQ(run("lut dielectric --plot maps.svg").code, 0);
    EXPECT_GT(test::read_text(path("maps.svg")).size(), 5000u);
}

// ---- the printed functions, compiled --------------------------------------------------------------------------------

class lut_text : public lut_command {
protected:
    int shell(const std::string& line) const {
        const int status = std::system(("cd '" + path("") + "' && { " + line + "; } >log 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string log() const { return test::read_text(path("log")); }
    static bool there(const std::string& tool) {
        return std::system(("command -v " + tool + " >/dev/null 2>&1").c_str()) == 0;
    }
};

const std::array<std::string, 4> kinds = {"dielectric", "gold", "dielectric --by eta --format rgba32f",
                                          "gold --format r8 --map cos"};

// A whole program around the function, which calls it, and its compiler. CUDA and Metal, whose compilers cannot be had
// everywhere, are C++ with the few declarations that the function needs.
struct receiver {
    std::string lang, before, after, file, command;
};

const std::vector<receiver> receivers = {
    {"glsl", "#version 330\nuniform sampler2D x;\nin float c;\nout vec4 o;\n",
     "void main() { o = vec4(vec3(CALL(x, ARGS)), 1.0); }\n", "t.frag", "glslangValidator t.frag"},
    {"essl", "#version 300 es\n",
     "uniform highp sampler2D x;\nin float c;\nout vec4 o;\nvoid main() { o = vec4(vec3(CALL(x, ARGS)), "
     "1.0); "
     "}\n",
     "t.frag", "glslangValidator t.frag"},
    {"hlsl", "Texture2D x : register(t0);\nSamplerState s : register(s0);\n",
     "float4 main(float c : A) : SV_Target { return float4(float3(CALL(x, s, ARGS)), 1); }\n", "t.frag",
     "glslangValidator -D -V -S frag -e main t.frag"},
    {"cg", "sampler2D x;\n",
     "float4 main(float c : TEXCOORD0) : COLOR { return float4(float3(CALL(x, ARGS)), 1); }\n", "t.frag",
     "glslangValidator -D -V -S frag -e main t.frag"},
    {"cuda",
     "struct float3 { float x, y, z; };\nstruct float4 { float x, y, z, w; };\n#define __device__\n"
     "typedef unsigned long long cudaTextureObject_t;\nfloat fminf(float, float), fmaxf(float, float), "
     "sqrtf(float);\n"
     "float3 make_float3(float, float, float);\nfloat3 vec3(float);\nfloat3 vec3(float3);\n"
     "template <class T> T tex2D(cudaTextureObject_t, float, float);\n",
     "float3 use(cudaTextureObject_t x, float c) { return vec3(CALL(x, ARGS)); }\n", "t.hpp",
     "c++ -std=c++17 -fsyntax-only -w -x c++ t.hpp"},
    {"msl",
     "struct float2 { float x, y; float2(float, float); };\nstruct float3 { float x, y, z; };\n"
     "struct float4 { float r; float3 rgb; };\nstruct level { explicit level(float); };\nstruct sampler {};\n"
     "float3 operator*(float3, float);\nfloat3 operator+(float3, float);\nfloat3 vec3(float);\nfloat3 "
     "vec3(float3);\n"
     "template <class T> struct texture2d { float4 sample(sampler, float2, level) const; };\n"
     "float saturate(float), sqrt(float);\n",
     "float3 use(texture2d<float> x, sampler s, float c) { return vec3(CALL(x, s, ARGS)); }\n", "t.hpp",
     "c++ -std=c++17 -fsyntax-only -w -x c++ t.hpp"},
    {"wgsl", "@group(0) @binding(0) var x: texture_2d<f32>;\n@group(0) @binding(1) var s: sampler;\n",
     "@fragment fn main(@location(0) c: f32) -> @location(0) vec4f { return vec4f(vec3f(CALL(x, s, ARGS)), "
     "1.0); "
     "}\n",
     "t.wgsl", "fresnel-naga t.wgsl t.spv"},
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

TEST_F(lut_text, compiles_where_it_is_read) {
    for (const receiver& r : receivers) {
        const std::string tool = r.command.substr(0, r.command.find(' '));
        if (!there(tool)) {
            std::printf("skipped: %s is not installed, which %s needs\n", tool.c_str(), r.lang.c_str());
            continue;
        }
        for (const std::string& kind : kinds) {
            const std::string name = kind.starts_with("gold") ? "gold_lut" : "dielectric_lut";
            const std::string arguments = kind.find("--by") == std::string::npos ? "c" : "1.5, c";
            const std::string after = replaced(replaced(r.after, "ARGS", arguments), "CALL", name);
            const std::string text = run("lut " + kind + " --lang " + r.lang).out;
            write(r.file, r.before + text + after);
            EXPECT_EQ(shell(r.command), 0) << r.lang << " " << kind << log() << text << after;
            write(r.file, r.before + replaced(text, "0.5", "0.5 +* ") + after);
            EXPECT_NE(shell(r.command), 0) << r.lang << " accepts what is broken";
        }
    }
}

TEST_F(lut_text, a_table_in_GLSL_ES_is_read_in_full_precision) {
    const std::string text = run("lut dielectric --fix n_t=1.5 --lang essl").out;
    EXPECT_EQ(text.find("precision highp float;\n"), 0u) << "a fragment stage has no precision of its own";
    EXPECT_NE(text.find("(highp sampler2D table, float cos_i)"), std::string::npos) << text;
}

TEST_F(lut_text, CUDA_is_told_how_to_describe_the_texture) {
    const auto text = [&](const std::string& arguments) {
        return run("lut " + arguments + " --lang cuda").out;
    };
    for (const std::string format : {"r8", "r16"})
        EXPECT_NE(text("dielectric --format " + format)
                      .find("normalizedCoords = 1, readMode = cudaReadModeNormalizedFloat\n"),
                  std::string::npos);
    EXPECT_NE(text("dielectric").find("normalizedCoords = 1, readMode = cudaReadModeElementType\n"),
              std::string::npos);
    EXPECT_NE(text("gold").find("cudaReadModeElementType, four channels\n"), std::string::npos);
    EXPECT_EQ(run("lut dielectric --lang hlsl").out.find("cudaReadMode"), std::string::npos);
    EXPECT_NE(text("dielectric --name fresnel_table").find("float fresnel_table_(fresnel_table table"),
              std::string::npos);
}

// A C program that prints what the header's function returns for each line of inputs, cos_i alone or by and cos_i.
std::string c_program(const std::string& function, bool rgb, bool two) {
    const std::string arguments = two ? "by, c" : "c";
    return std::string("#include \"t.h\"\n#include <stdio.h>\nint main(void) {\n    float c, by = 0.0f;\n") +
           "    while (scanf(\"%f %f\", &by, &c) == 2) {\n        float rgb[3] = {0.0f, 0.0f, 0.0f};\n" +
           (rgb ? "        " + function + "(" + arguments + ", rgb);\n"
                : "        rgb[0] = " + function + "(" + arguments + ");\n") +
           "        printf(\"%a %a %a\\n\", (double)rgb[0], (double)rgb[1], (double)rgb[2]);\n    }\n    "
           "return 0;\n}\n";
}

TEST_F(lut_text, c99_returns_what_was_measured) {
    struct one_case {
        std::string arguments;
        lut_subject subject;
        float by;
    };
    const std::vector<one_case> cases = {
        {"dielectric --fix n_t=1.5 --size 33", glass(), 0},
        {"gold --space acescg --size 32", gold(), 0},
        {"dielectric --fix n_i=1.5 --fix n_t=1 --size 64", inside_glass(), 0},
        {"dielectric --by eta --size 32x16", model_subject("dielectric", {}, "eta"), 1.717f}};
    for (const one_case& k : cases) {
        const bool rgb = k.subject.channels == 3, two = k.subject.by.has_value();
        const nlohmann::json claimed = json("lut " + k.arguments + " --map sqrt-cos --out t.h --json");
        write("t.c", c_program(rgb ? "gold_lut" : "dielectric_lut", rgb, two));
        ASSERT_EQ(shell("cc -std=c99 -O2 -Wall -Wextra -Wconversion -Wdouble-promotion -Wpedantic -Werror "
                        "-ffp-contract=off t.c -o t -lm"),
                  0)
            << log();
        const std::size_t columns = claimed["size"][0], rows = claimed["size"][1];
        const lut_reference exact = make_reference(k.subject, columns, double(k.by));
        std::string lines;
        for (const float c : exact.cos_i) {
            char line[80];
            std::snprintf(line, sizeof line, "%a %a\n", double(k.by), double(c));
            lines += line;
        }
        write("in", lines);
        ASSERT_EQ(shell("./t <in >out"), 0);
        const lut table = bake(k.subject, {"sqrt-cos", columns, rows, texel_format::c});
        FILE* out = std::fopen(path("out").c_str(), "r");
        double most = 0, read[3];
        for (std::size_t i = 0; i < exact.cos_i.size(); ++i) {
            ASSERT_EQ(std::fscanf(out, "%la %la %la", &read[0], &read[1], &read[2]), 3);
            const std::array<float, 3> emulated = sample(table, exact.cos_i[i], k.by);
            for (std::size_t c = 0; c < table.channels(); ++c) {
                EXPECT_EQ(static_cast<float>(read[c]), emulated[c])
                    << k.arguments << " cos_i " << exact.cos_i[i];
                most = std::max(most, std::abs(read[c] - exact.value[i][c]));
            }
        }
        std::fclose(out);
        const double most_claimed = claimed["error"]["max"];
        EXPECT_LE(most, most_claimed) << k.arguments;
        if (!two) {
            EXPECT_EQ(most, most_claimed) << k.arguments;
        }
    }
}

TEST_F(lut_text, c99_stays_in_its_table_for_any_input) {
    ASSERT_EQ(run("lut dielectric --out t.h").code, 0);
    write("t.c", c_program("dielectric_lut", false, false));
    ASSERT_EQ(shell("cc -std=c99 -fsanitize=address,undefined -fno-sanitize-recover t.c -o t -lm"), 0)
        << log();
    write("in", "0 nan\n0 -1\n0 2\n0 inf\n0 -inf\n0 1e-40\n");
    EXPECT_EQ(shell("./t <in"), 0) << log();
}

// ---- the printed functions, run on a texture ------------------------------------------------------------------------

// The largest error of the GLSL function on the device, over the reference of the table's middle row.
double device_error(const test::texture_device& device, const lut& table) {
    const bool two = table.subject.by.has_value(), rgb = table.channels() == 3;
    const float by =
        two ? static_cast<float>(std::midpoint(table.subject.by->lo, table.subject.by->hi)) : 0.0f;
    const lut_reference exact = make_reference(table.subject, table.columns, double(by));
    std::vector<float> pairs;
    for (const float c : exact.cos_i)
        pairs.insert(pairs.end(), {c, by});
    const std::string text = sampler_text("glsl", table, {"read_table", "", ""});
    const std::vector<float> read =
        device.run(table, text, two ? "read_table(table_, by, cos_i)" : "read_table(table_, cos_i)", pairs);
    double most = 0;
    for (std::size_t i = 0; i < exact.cos_i.size(); ++i)
        for (std::size_t c = 0; c < (rgb ? 3u : 1u); ++c)
            most = std::max(most, std::abs(double(read[3 * i + c]) - exact.value[i][c]));
    return most;
}

class lut_device : public testing::Test {
protected:
    void SetUp() override {
        try {
            device = std::make_unique<test::texture_device>();
        } catch (const std::runtime_error& reason) {
            GTEST_SKIP() << "skipped: " << reason.what();
        }
    }
    std::unique_ptr<test::texture_device> device;
};

TEST_F(lut_device, glsl_reads_with_the_claimed_error) {
    for (const lut_subject& subject : {glass(), gold(), gold(color_space::srgb), inside_glass()})
        for (const texel_format format :
             {texel_format::r8, texel_format::r16, texel_format::r16f, texel_format::rgba32f})
            for (const std::size_t size : {16u, 33u, 256u}) {
                const lut table = baked(subject, size, "sqrt-cos", format);
                const double found = device_error(*device, table);
                // llvmpipe filters eight bits in eight bits: half a step more
                const double more = format == texel_format::r8 ? 1 / 510.0 : 0;
                EXPECT_LE(found, std::max(table.error.max, table.error.max_8_bit) * 1.01 + more)
                    << subject.caption << " " << to_string(format) << " " << size;
                EXPECT_GE(found, table.error.max * 0.99) << subject.caption << " " << to_string(format);
            }
}

TEST_F(lut_device, glsl_reads_two_axes) {
    for (const texel_format format : {texel_format::r16, texel_format::r16f}) {
        const lut table = bake(model_subject("dielectric", {}, "eta=1.2:2.5"), {{}, 64, 32, format});
        const double found = device_error(*device, table);
        EXPECT_LE(found, table.error.max * 1.01);
        EXPECT_GE(found, table.error.max * 0.3) << "one row of many";
    }
}

TEST_F(lut_device, a_wrong_texel_shows_there_too) {
    lut table = baked(glass(), 64, "sqrt-cos");
    table.texels[40] += 0.01f;
    EXPECT_GT(device_error(*device, table), 0.009);
}

// A program of the technique lut, drawn: F in all three channels, of a table of one channel as of one of a colour.
void expect_drawn(const test::texture_device& device, const model_request& wanted, const std::string& rows,
                  float by) {
    const auto text = [&](stage s) {
        return technique_text(find_dialect("glsl"), find_technique("lut"), wanted, s, "lut_test");
    };
    const std::string vertex = text(stage::vertex), fragment = text(stage::fragment);
    for (const texel_format format : {texel_format::r8, texel_format::r16, texel_format::r16f}) {
        const lut table = bake(model_subject(wanted.model, wanted.fixed, rows), {"cos", 64, 32, format});
        for (const float c : {0.05f, 0.3f, 0.71f, 1.0f}) {
            const std::array<float, 3> F = sample(table, c, by);
            const std::array<float, 4> color = device.draw(table, vertex, fragment, c, by, rows.c_str());
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(color[k], F[table.channels() == 3 ? k : 0], 0.003)
                    << wanted.model << " " << to_string(format) << " " << c << " " << k;
        }
    }
}

TEST_F(lut_device, a_program_draws_with_the_table_that_it_names) {
    expect_drawn(*device, {"dielectric", one("n_t", 1.5)}, "", 0);
    expect_drawn(*device, {"dielectric"}, "eta", 1.7f);
    expect_drawn(*device, {"schlick"}, "f0", 0.4f);
    expect_drawn(*device, {"schlick", {{"f0", {1, 0.78, 0.34}}}}, "", 0);
}

TEST_F(lut_command, a_material_s_text_cites_the_measurement) {
    for (const char* options : {"", " --format c"}) {
        const std::string printed = run(std::string("lut gold --size 16") + options).out;
        EXPECT_NE(printed.find("// data      P. B. Johnson and R. W. Christy."), std::string::npos)
            << printed;
        EXPECT_EQ(run(std::string("lut schlick --size 16") + options).out.find("// data"), std::string::npos);
    }
}

// ---- bad input ----------------------------------------------------------------------------------------------------

TEST_F(lut_command, what_cannot_be_baked_is_refused) {
    expect_refused("lut", {"MODEL"});
    expect_refused("lut dielectrc", {"dielectrc", "dielectric"});
    expect_refused("lut dielectric --size 1", {"--size 1", "[2, 4096]"});
    expect_refused("lut dielectric --size 5000", {"5000", "[2, 4096]"});
    expect_refused("lut dielectric --size 2.5", {"2.5", "whole"});
    expect_refused("lut dielectric --size many", {"many"});
    expect_refused("lut dielectric --size 64x32", {"64x32", "--by"});
    expect_refused("lut dielectric --by eta --size 512", {"512", "[2, 256]"});
    expect_refused("lut dielectric --by eta --size 64x1", {"--size 1", "rows"});
    expect_refused("lut dielectric --map sin", {"--map 'sin'", "cos, sqrt-cos or auto"});
    expect_refused("lut dielectric --format r32", {"r32", "r8, r16, r16f, rgba32f or c"});
    expect_refused("lut dielectric --format r8 --out t.exr", {"t.exr", "r8", ".png"});
    expect_refused("lut dielectric --out t.jpg", {"t.jpg", ".png, .exr or .h"});
    expect_refused("lut dielectric --out nowhere/t.png", {"nowhere/t.png", "cannot be written"});
    expect_refused("lut dielectric --lang c --format r8", {"--lang c", "--format r8"});
    expect_refused("lut dielectric --lang glsl --format c", {"--lang glsl", "--format c"});
    expect_refused("lut dielectric --lang glls", {"glls", "glsl"});
    expect_refused("lut dielectric --fix n_q=2", {"n_q", "n_i, n_t"});
    expect_refused("lut dielectric --fix n_t=0", {"n_t = 0", "[0.001, 1000]"});
    expect_refused("lut gold --fix n_t=2", {"--fix", "gold", "material"});
    expect_refused("lut gold --by eta", {"--by eta", "gold", "material"});
    expect_refused("lut dielectric --ambient 1.333", {"--ambient 1.333", "material", "--fix n_i=1.333"});
    expect_refused("lut schlick --space p3", {"--space p3", "material", "--fix"});
    expect_refused("lut dielectric --plot t.gif", {"--plot 't.gif'", ".svg"});
    expect_refused("lut dielectric --by eta --plot t.svg", {"--plot", "--by"});
    expect_refused("lut dielectric --errors --out t.png", {"t.png", "--errors"});
    expect_refused("lut dielectric --plot t.svg --out t.png", {"t.png", "--plot"});
    expect_refused("lut dielectric --errors --plot t.svg", {"--errors", "--plot"});
}

TEST_F(lut_command, a_second_axis_that_cannot_be_is_refused) {
    expect_refused("lut dielectric --by k", {"--by 'k'", "eta or f0"});
    expect_refused("lut dielectric --by eta=2", {"eta=2", "LO:HI"});
    expect_refused("lut dielectric --by eta=a:b", {"eta=a:b", "numbers"});
    expect_refused("lut dielectric --by eta=2:1.5", {"eta=2:1.5", "rise"});
    expect_refused("lut one_minus_cos --by f0", {"one_minus_cos has no f0"});
    expect_refused("lut schlick --by eta", {"schlick has no eta"});
    expect_refused("lut dielectric --by eta --fix n_t=2", {"n_t", "--by eta"});
    expect_refused("lut schlick --by f0=-1:1", {"f0 = -1", "[0, 1]"});
    expect_refused("lut dielectric --by f0=0:0.2", {"f0=0:0.2", "(0, 1)"});
    expect_refused("lut conductor --fix k_t=2 --by f0", {"k_t", "--by eta"});
}

TEST_F(lut_command, a_critical_angle_is_named_in_the_refusal) {
    expect_refused("lut dielectric --fix n_i=1.5 --fix n_t=1 --map cos",
                   {"--map cos", "critical angle at 41.81", "0.23", "sqrt-cos"});
    expect_refused("lut dielectric --by eta=0.8:1.5", {"eta=0.8:1.5", "above 1", "critical angle"});
    expect_refused("lut schlick_internal --by eta=0.4:0.9", {"above 1", "1 / eta"});
    expect_refused("lut n-bk7 --ambient 1.6", {"n-bk7", "between 70.", "critical angle"});
}

TEST_F(lut_command, help_shows_examples) {
    EXPECT_NE(run("lut --help").out.find("Examples:"), std::string::npos);
}

} // namespace
