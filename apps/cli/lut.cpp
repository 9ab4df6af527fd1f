#include "colour_options.hpp"
#include "commands.hpp"
#include "figure_files.hpp"
#include "parameter_options.hpp"

#include "analysis/curve.hpp"
#include "analysis/drawing.hpp"
#include "analysis/plot.hpp"
#include "emit/lut_study.hpp"
#include "emit/lut_text.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace fresnel::cli {

namespace {

struct options {
    std::string what, size, map = "auto", by, format, language, out, name, plot;
    std::vector<std::string> fixed;
    colour_options colour;
    bool json = false, errors = false;
};

// ---- the request --------------------------------------------------------------------------------------------

emit::lut_subject subject_of(const options& given) {
    const plot_subject found = find_subject(given.what);
    if (found.model != nullptr) {
        refuse_colours(given.colour, "a material");
        emit::fixed_values fixed;
        for (const std::string& text : given.fixed)
            add_fixed(text, fixed);
        return emit::model_subject(given.what, fixed, given.by);
    }
    if (!given.fixed.empty())
        throw bad_input(fmt::format("--fix '{}': {} is a material, which has no parameters",
                                    given.fixed.front(), given.what));
    if (!given.by.empty())
        throw bad_input(
            fmt::format("--by {}: {} is a material, with one index; name a model", given.by, given.what));
    return emit::material_subject(*found.substance, chosen_space(given.colour), chosen_ambient(given.colour));
}

std::size_t texel_count(const std::string& text, std::string_view part) {
    const double value = parse_number("--size", part);
    if (value != std::floor(value) || value < 0 || value > 1e6)
        throw bad_input(
            fmt::format("--size '{}': must be whole numbers of texels in [{}, {}], N or COLUMNSxROWS", text,
                        emit::least_texels, emit::most_columns));
    return static_cast<std::size_t>(value);
}

// "64", or "64x16" for a table with a second axis.
void choose_size(const options& given, bool two_axes, emit::lut_request& wanted) {
    wanted.columns = 64, wanted.rows = two_axes ? 32 : 1;
    if (given.size.empty()) return;
    const std::size_t times = given.size.find('x');
    wanted.columns = texel_count(given.size, std::string_view(given.size).substr(0, times));
    if (two_axes) wanted.rows = wanted.columns;
    if (times == std::string::npos) return;
    if (!two_axes) throw bad_input(fmt::format("--size '{}': one number, or --by with two", given.size));
    wanted.rows = texel_count(given.size, std::string_view(given.size).substr(times + 1));
}

std::string ending_of(emit::texel_format format) {
    if (format == emit::texel_format::c) return ".h";
    return format == emit::texel_format::r8 || format == emit::texel_format::r16 ? ".png" : ".exr";
}

emit::texel_format format_for(const options& given) {
    const std::string ending = std::filesystem::path(given.out).extension().string();
    if (!given.format.empty()) {
        const emit::texel_format format = emit::find_texel_format(given.format);
        if (!given.out.empty() && ending != ending_of(format))
            throw bad_input(fmt::format("--out '{}': a table of format {} is a {} file", given.out,
                                        given.format, ending_of(format)));
        return format;
    }
    if (given.out.empty()) return given.language == "c" ? emit::texel_format::c : emit::texel_format::r16f;
    for (const auto format : {emit::texel_format::r8, emit::texel_format::r16f, emit::texel_format::c})
        if (ending == ending_of(format)) return format;
    throw bad_input(fmt::format("--out '{}': must end in .png, .exr or .h", given.out));
}

emit::lut_request request_of(const options& given, const emit::lut_subject& subject) {
    emit::lut_request wanted;
    if (given.map != "auto") wanted.map = emit::find_lut_map(given.map).name;
    wanted.format = format_for(given);
    choose_size(given, subject.by.has_value(), wanted);
    return wanted;
}

std::string made_by(const options& given) {
    std::string line = "fresnel lut " + shell_word(given.what);
    const auto add = [&](std::string_view option, const std::string& value) {
        if (!value.empty()) line += fmt::format(" {} {}", option, shell_word(value));
    };
    for (const std::string& fixed : given.fixed)
        add("--fix", fixed);
    add("--by", given.by), add("--size", given.size), add("--map", given.map == "auto" ? "" : given.map);
    add("--format", given.format), line += colour_arguments(given.colour);
    add("--lang", given.language), add("--name", given.name), add("--out", given.out);
    return line;
}

// ---- what is printed and written --------------------------------------------------------------------------------

nlohmann::json to_json(const emit::lut& table, const std::string& text, const options& given) {
    const emit::lut_error& e = table.error;
    nlohmann::json by;
    if (table.subject.by)
        by = {{"name", table.subject.by->name}, {"range", {table.subject.by->lo, table.subject.by->hi}}};
    nlohmann::json critical, file;
    if (table.subject.critical > 0) critical = table.subject.critical;
    if (!given.out.empty()) file = given.out;
    return {{"name", table.subject.name},
            {"caption", table.subject.caption},
            {"map", table.map->name},
            {"critical_cosine", critical},
            {"by", by},
            {"size", {table.columns, table.rows}},
            {"channels", table.subject.channels},
            {"format", emit::to_string(table.format)},
            {"range", {table.lo, table.hi}},
            {"error",
             {{"max", e.max},
              {"rms", e.rms},
              {"cos_i", e.cos_i},
              {"theta", degrees_of_cosine(e.cos_i)},
              {"by", table.subject.by ? nlohmann::json(e.by) : nlohmann::json()},
              {"max_8_bit_weights", e.max_8_bit},
              {"at_critical", e.at_critical}}},
            {"file", file},
            {"texels", table.texels},
            {"text", text}};
}

void print_errors(const options& given, const emit::lut_subject& subject) {
    if (!given.json) {
        fmt::print("{}", emit::study_text(subject));
        return;
    }
    const std::vector<std::size_t> sizes = emit::studied_sizes(subject);
    nlohmann::json all = nlohmann::json::array();
    for (const emit::lut_study_row& row : emit::study_lut(subject, sizes))
        for (std::size_t i = 0; i < sizes.size(); ++i)
            all.push_back({{"map", row.map->name},
                           {"format", emit::to_string(row.format)},
                           {"size", sizes[i]},
                           {"max", row.error[i].max},
                           {"rms", row.error[i].rms},
                           {"max_8_bit_weights", row.error[i].max_8_bit}});
    print_json(all);
}

void draw(const options& given, const emit::lut_subject& subject) {
    if (subject.by)
        throw bad_input(fmt::format("--plot '{}': draws tables of one row; leave out --by", given.plot));
    if (isatty(STDERR_FILENO) != 0) say("lut: measuring tables of 8 to 1024 texels\n");
    const std::string id = slug(std::filesystem::path(given.plot).stem().string());
    write_file(given.plot, writer_of("--plot", given.plot)(emit::lut_figure(subject, id)));
    fmt::print("wrote {}\n", given.plot);
}

void bake_table(const options& given, const emit::lut_subject& subject) {
    const emit::lut_request wanted = request_of(given, subject);
    const bool array = wanted.format == emit::texel_format::c;
    const std::string language = !given.language.empty() ? given.language : array ? "c" : "glsl";
    const emit::lut_names names{given.name, made_by(given), array ? "" : given.out};
    if (array != (emit::find_language(language).id == "c"))
        throw bad_input(
            fmt::format("--lang {} with --format {}: C reads the array of --format c, the other languages "
                        "textures",
                        language, emit::to_string(wanted.format)));
    if (wanted.columns * wanted.rows > 20000 && isatty(STDERR_FILENO) != 0)
        say("lut: measuring {} x {} texels\n", wanted.columns, wanted.rows);
    const emit::lut table = emit::bake(subject, wanted);
    const std::string text =
        array ? emit::lut_header(table, names) : emit::sampler_text(language, table, names);
    if (!given.out.empty()) write_file(given.out, array ? text : emit::lut_image(table, names));
    if (given.json) return print_json(to_json(table, text, given));
    if (!array || given.out.empty()) fmt::print("{}", text);
    if (!given.out.empty())
        say("lut: wrote {}, {}: {}\n", given.out, table.map->name, emit::error_text(table));
}

void check(const options& given) {
    const bool draws = !given.plot.empty();
    if (!given.out.empty() && (given.errors || draws))
        throw bad_input(fmt::format("--out '{}': {} bakes no table; leave one of them out", given.out,
                                    draws ? "--plot" : "--errors"));
    if (given.errors && draws) throw bad_input("--errors: prints what --plot draws; give one of them");
}

void run(const options& given) {
    check(given);
    if (!given.plot.empty()) writer_of("--plot", given.plot), require_writable("--plot", given.plot);
    if (!given.out.empty()) require_writable("--out", given.out);
    const emit::lut_subject subject = subject_of(given);
    if (given.errors) return print_errors(given, subject);
    if (!given.plot.empty()) return draw(given, subject);
    bake_table(given, subject);
}

void add_table_options(CLI::App& command, options& given) {
    command
        .add_option("--size", given.size,
                    "texels, [2, 4096] (default 64); with --by COLUMNSxROWS, each [2, 256] (default 64x32)")
        ->type_name("N");
    command
        .add_option("--map", given.map,
                    "cos, sqrt-cos, or auto: the one with the smaller measured error (default auto)")
        ->type_name("M");
    command.add_option("--by", given.by, "a second axis: eta or f0, or with a range, eta=1.1:2")
        ->type_name("AXIS");
    command
        .add_option("--format", given.format,
                    "r8, r16 (PNG), r16f, rgba32f (OpenEXR) or c (an array) (default: by the ending of FILE)")
        ->type_name("F");
    command
        .add_option("--fix", given.fixed,
                    "a parameter of the model, for all channels or R,G,B (default: registry)")
        ->type_name("PARAM=VALUE")
        ->allow_extra_args(false);
}

} // namespace

void add_lut(CLI::App& app) {
    CLI::App* command = add_command(
        app, "lut", "A model or material as a table, with its measured error and the function that reads it",
        "  fresnel lut dielectric --fix n_t=1.5 --out glass.png            8 bits, and its GLSL\n"
        "  fresnel lut gold --space acescg --format r16f --lang hlsl --out gold.exr\n"
        "  fresnel lut dielectric --by eta=1.2:2.5 --size 64x32 --format r16 --out glasses.png\n"
        "  fresnel lut dielectric --fix n_i=1.5 --fix n_t=1 --format c       from inside, a C array\n"
        "  fresnel lut schlick --by f0 --lang wgsl\n"
        "  fresnel lut dielectric --errors                                   every map, format and four "
        "sizes\n"
        "  fresnel lut dielectric --plot maps.svg                            error against size");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL|MATERIAL", given->what, "see `fresnel models` and `fresnel materials`")
        ->required();
    add_table_options(*command, *given);
    command
        ->add_option(
            "--lang", given->language,
            "of the function: glsl, essl, hlsl, cg (HLSL of shader models 2 and 3, and Cg), msl, wgsl, "
            "osl, cuda, slang or c (default glsl)")
        ->type_name("L");
    command->add_option("--name", given->name, "name of the function")->type_name("N");
    command->add_option("--out", given->out, "write the table: .png, .exr or .h")->type_name("FILE");
    add_colour_options(*command, given->colour);
    command->add_flag("--errors", given->errors,
                      "print the errors of every map and format at 16, 32, 64 and 256 texels; with --by at "
                      "16, 32 and 64 squared");
    command
        ->add_option("--plot", given->plot,
                     "draw the error against the size: .svg, .png, .pdf, .csv or .json")
        ->type_name("FILE");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
