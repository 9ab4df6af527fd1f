#include "commands.hpp"

#include "conform/conform.hpp"
#include "conform/expression.hpp"
#include "error.hpp"
#include "files.hpp"
#include "render/compute.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

namespace fresnel::cli {

namespace {

struct options {
    std::string file, arguments, language;
    conform::conform_request request;
    std::vector<std::string> fixed, ranges;
    bool json = false;
};

std::string language_of(const std::string& file) {
    const std::string ending = std::filesystem::path(file).extension().string();
    for (const char* each : {".hlsl", ".hlsli", ".fx", ".fxh", ".cginc", ".cg", ".ush", ".usf"})
        if (ending == each) return "hlsl";
    for (const char* each : {".glsl", ".frag", ".vert", ".comp", ".fs", ".vs", ".glslinc"})
        if (ending == each) return "glsl";
    if (ending == ".wgsl") return "wgsl";
    throw bad_input(
        fmt::format("{}: its language is not known by its ending; give --lang glsl, hlsl or wgsl", file));
}

// "NAME=VALUES" taken apart
std::pair<std::string, std::vector<double>> assignment(std::string_view option, const std::string& text,
                                                       std::size_t count) {
    const std::size_t equals = text.find('=');
    const std::string form = count == 1 ? "PARAMETER=VALUE" : "PARAMETER=LOW,HIGH";
    if (equals == std::string::npos || equals == 0)
        throw bad_input(fmt::format("{} '{}': must be {}", option, text, form));
    std::vector<double> values;
    for (const std::string& part : conform::split_list(std::string_view(text).substr(equals + 1)))
        values.push_back(parse_number(fmt::format("{} {}", option, text.substr(0, equals)), part));
    if (values.size() != count) throw bad_input(fmt::format("{} '{}': must be {}", option, text, form));
    return {text.substr(0, equals), values};
}

void complete(options& given) {
    conform::conform_request& request = given.request;
    request.file = given.file;
    request.language = given.language.empty() ? language_of(given.file) : given.language;
    if (request.language != "glsl" && request.language != "hlsl" && request.language != "wgsl")
        throw bad_input(fmt::format("--lang = '{}': must be glsl, hlsl or wgsl", request.language));
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(given.file, ignored))
        throw bad_input(fmt::format("{}: there is no such file", given.file));
    request.text = read_file(given.file);
    if (!given.arguments.empty()) request.arguments = conform::split_list(given.arguments);
    for (const std::string& fixed : given.fixed) {
        const auto [name, values] = assignment("--fix", fixed, 1);
        request.fixed[name] = values[0];
    }
    for (const std::string& range : given.ranges) {
        const auto [name, values] = assignment("--range", range, 2);
        request.ranges[name] = {values[0], values[1]};
    }
}

// In so many digits, or "none".
std::string in_digits(const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}g}", *value, digits) : "none";
}

nlohmann::json described(const conform::conform_request& request, const conform::conformance& found) {
    nlohmann::json failures = nlohmann::json::array(), jumps = failures, bound = nlohmann::json::object();
    for (const conform::failed_input& f : found.first_failures)
        failures.push_back({{"inputs", object(f.inputs)},
                            {"arguments", f.arguments},
                            {"expected", f.expected},
                            {"got", f.got},
                            {"why", f.why}});
    for (const conform::discontinuity& d : found.discontinuities)
        jumps.push_back({{"inputs", object(d.inputs)}, {"jump", d.jump}});
    for (const auto& [argument, expression] : found.bound)
        bound[argument] = expression;
    nlohmann::json all = {{"file", request.file},
                          {"function", found.signature},
                          {"language", request.language},
                          {"model", request.model},
                          {"device", found.device},
                          {"arguments", bound},
                          {"fixed", object(found.fixed)},
                          {"inputs", found.inputs},
                          {"tolerance", request.tolerance},
                          {"max_error", or_null(found.max_error)},
                          {"max_relative_error", or_null(found.max_relative_error)},
                          {"rms_error", or_null(found.rms_error)},
                          {"nan", found.nan},
                          {"negative", found.negative},
                          {"above_one", found.above_one},
                          {"beyond_nan", found.beyond_nan},
                          {"beyond_range", found.beyond_range},
                          {"lowest", or_null(found.lowest)},
                          {"highest", or_null(found.highest)},
                          {"discontinuities", jumps},
                          {"first_failures", failures},
                          {"findings", found.findings},
                          {"conforms", found.conforms()}};
    if (request.exact) {
        all["exact_max_error"] = or_null(found.exact_max_error);
        all["exact_rms_error"] = or_null(found.exact_rms_error);
    }
    return all;
}

std::string listed(const std::vector<std::pair<std::string, double>>& values) {
    std::string text;
    for (const auto& [name, value] : values)
        text += fmt::format("{}{} = {:.9g}", text.empty() ? "" : ", ", name, value);
    return text;
}

// Without the sign that a NaN may have.
std::string listed(const std::vector<float>& values) {
    std::string text;
    for (const float x : values)
        text += (text.empty() ? "" : ", ") + (x != x ? "nan" : fmt::format("{:.9g}", x));
    return text;
}

void print_report(const conform::conform_request& request, const conform::conformance& found) {
    fmt::print("{}\nas {}: ", found.signature, request.model);
    for (std::size_t i = 0; i < found.bound.size(); ++i)
        fmt::print("{}{} = {}", i == 0 ? "" : ", ", found.bound[i].first, found.bound[i].second);
    if (!found.fixed.empty()) fmt::print("; {}", listed(found.fixed));
    fmt::print("\non {}\n\n", found.device);
    fmt::print("inputs          {}\nlargest error   {} ({} of the value), rms {}\n", found.inputs,
               in_digits(found.max_error, 3), in_digits(found.max_relative_error, 3),
               in_digits(found.rms_error, 3));
    if (request.exact)
        fmt::print("against exact   {}, rms {}\n", in_digits(found.exact_max_error, 3),
                   in_digits(found.exact_rms_error, 3));
    fmt::print("NaN             {}, and {} just outside of [0, 1]\nnegative        {}\nabove one       "
               "{}\nvalues          "
               "[{}, {}]\njumps           {}\n",
               found.nan, found.beyond_nan, found.negative, found.above_one, in_digits(found.lowest, 9),
               in_digits(found.highest, 9), found.discontinuities.size());
    for (const conform::failed_input& f : found.first_failures)
        fmt::print("  {}: gives {}, must be {:.9g}: {}\n", listed(f.inputs), listed(f.got),
                   fmt::join(f.expected, ", "), f.why);
    fmt::print("\n");
    for (const std::string& finding : found.findings)
        fmt::print("finding: {}\n", finding);
    if (found.conforms())
        fmt::print("{} is {}, within {}\n", found.signature, request.model, request.tolerance);
}

void run(options& given) {
    complete(given);
    conform::conformance found;
    try {
        found = conform::conform(given.request);
    } catch (const render::no_device& reason) {
        throw failure(
            fmt::format("--lang {}: cannot be run here: {}", given.request.language, reason.what()));
    }
    if (given.json)
        print_json(described(given.request, found));
    else
        print_report(given.request, found);
    if (found.conforms()) return;
    std::fflush(stdout);
    throw failure(fmt::format("{}: {} is not {}: {}", given.file, given.request.function, given.request.model,
                              found.findings[0]));
}

// CLI11's own check prints the largest double in 309 digits.
std::string positive_number(const std::string& text) {
    const char* const end = text.data() + text.size();
    double value = 0;
    const auto [next, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && next == end && value > 0
               ? ""
               : fmt::format("'{}' must be a number above 0", text);
}

} // namespace

void add_conform(CLI::App& app) {
    CLI::App* command = add_command(
        app, "conform", "Run somebody's GLSL, HLSL or WGSL function against a model",
        "  fresnel conform brdf.glsl --function F_Schlick --as schlick\n"
        "  fresnel conform lighting.hlsl --function fresnel --as dielectric --args 'cos_i, 1/eta'\n"
        "  fresnel conform pbr.wgsl --function f_metal --as f82_tint --args 'f0, tint, direction, normal' "
        "--json");
    const auto given = std::make_shared<options>();
    command->add_option("FILE", given->file, "shader text that defines the function")->required();
    command->add_option("--function", given->request.function, "its name")->required()->type_name("NAME");
    command->add_option("--as", given->request.model, "the model it is meant to be")
        ->required()
        ->type_name("MODEL");
    command
        ->add_option(
            "--args", given->arguments,
            "for each argument what it is given: parameters of the model, eta, f0, cos_i, normal, direction, "
            "numbers, + - * / sqrt() vec3(); default: by the arguments' names")
        ->type_name("A,B,...");
    command->add_option("--lang", given->language, "glsl, hlsl or wgsl (default: by the file's ending)")
        ->type_name("L");
    command->add_option("--fix", given->fixed, "a parameter that does not vary")
        ->type_name("PARAM=VALUE")
        ->expected(1)
        ->allow_extra_args(false);
    command->add_option("--range", given->ranges, "a parameter's range")
        ->type_name("PARAM=LOW,HIGH")
        ->expected(1)
        ->allow_extra_args(false);
    command->add_option("--tolerance", given->request.tolerance, "largest absolute error (default 1e-4)")
        ->check(positive_number);
    command
        ->add_option("--relative", given->request.relative,
                     "largest relative error against an exact model (default 1e-2)")
        ->check(positive_number);
    command->add_flag("--exact", given->request.exact, "also report the error against the exact equations");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
