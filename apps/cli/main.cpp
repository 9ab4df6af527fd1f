#include "commands.hpp"

#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/leftover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace fresnel::cli {

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& examples) {
    CLI::App* command = app.add_subcommand(name, description);
    command->footer("Examples:\n" + examples);
    return command;
}

nlohmann::json object(const std::vector<std::pair<std::string, double>>& values) {
    nlohmann::json all = nlohmann::json::object();
    for (const auto& [name, value] : values)
        all[name] = value;
    return all;
}

void print_json(const nlohmann::json& value) { fmt::print("{}", json_text(value)); }

void print_trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
}

bool colours_wanted() { return isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr; }

double parse_number(std::string_view argument, std::string_view text) {
    double value = 0;
    if (read_number(text, value)) return value == 0 ? 0 : value; // -0 is 0
    throw bad_input(fmt::format("{} = '{}': is not a number", argument, text));
}

double parse_parameter(const parameter& p, std::string_view text) {
    const double value = parse_number(p.name, text);
    check_range(p, value);
    return value;
}

std::string shell_word(std::string_view text) {
    constexpr std::string_view plain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789%+,-./:=@_";
    if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? "'\\''" : std::string(1, c);
    return word + "'";
}

namespace {

// An empty value would be taken for none.
void refuse_empty_values(CLI::App& app) {
    for (CLI::Option* option : app.get_options())
        option->check([](const std::string& value) { return value.empty() ? "must not be ''" : ""; });
    for (CLI::App* command : app.get_subcommands({}))
        refuse_empty_values(*command);
}

void build(CLI::App& app) {
    app.require_subcommand(1);
    app.set_version_flag("--version", "fresnel " FRESNEL_VERSION);
    app.footer(
        "Examples:\n"
        "  fresnel f0 copper                          F0, F82 and hex of copper, with how they were made\n"
        "  fresnel compare copper gold --out out      which approximation to use, as a report with figures\n"
        "  fresnel eval dielectric --n-t 1.5 --theta 56.31\n"
        "  fresnel identify '#ffdea3'                 what has this F0\n"
        "  fresnel plot copper schlick --out copper.svg\n"
        "  fresnel models schlick                     equation, parameters, error and source of one model\n"
        "`fresnel COMMAND --help` shows the options and examples of a command.");
    add_models(app);
    add_eval(app);
    add_materials(app);
    add_f0(app);
    add_compare(app);
    add_angles(app);
    add_figures(app);
    add_claims(app);
    add_convert(app);
    add_prove(app);
    add_identify(app);
    add_plot(app);
    add_shader(app);
    add_lut(app);
    add_conform(app);
    add_cost(app);
    refuse_empty_values(app);
}

void check_option(const CLI::App& app, const std::string& given) {
    if (app.get_option_no_throw(given) != nullptr) return;
    const std::vector<std::string> names = {"--help", "--version"};
    throw bad_input(fmt::format("option '{}' is unknown{}; `fresnel --help` lists them", given,
                                did_you_mean(given, names)));
}

// A misspelt command is told apart from a misspelt option, so that the nearest command can be named.
void check_command(const CLI::App& app, int argc, char** argv) {
    if (argc < 2) return;
    if (argv[1][0] == '-') return check_option(app, argv[1]);
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({}))
        names.push_back(command->get_name());
    for (const std::string& name : names)
        if (name == argv[1]) return;
    throw bad_input(fmt::format("command '{}' is unknown{}; `fresnel --help` lists them", argv[1],
                                did_you_mean(argv[1], names)));
}

// One line whatever a value holds: control bytes as \n, \t or \x1b.
std::string on_one_line(std::string_view message) {
    std::string line;
    for (const char c : message) {
        const auto byte = static_cast<unsigned char>(c);
        line += c == '\n'                  ? "\\n"
                : c == '\t'                ? "\\t"
                : byte < 32 || byte == 127 ? fmt::format("\\x{:02x}", byte)
                                           : std::string(1, c);
    }
    return line;
}

int report(std::string_view message, int code) {
    remove_empty_folders();
    while (message.ends_with('\n'))
        message.remove_suffix(1);
    say("fresnel: {}\n", on_one_line(message));
    return code;
}

// What was printed has arrived.
int finished(int code) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.flush()) return code;
    return report("standard output: cannot be written", 1);
}

// A standard stream that is closed stays one that fails, and no file that is opened takes its number.
void hold_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

// The arguments, last first as CLI11 wants them. It takes -.5 for an option and -0.5 for a number.
std::vector<std::string> arguments_of(int argc, char** argv) {
    std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
    for (std::string& one : arguments)
        if (one.size() > 2 && one.starts_with("-.") && one[2] >= '0' && one[2] <= '9') one.insert(1, "0");
    std::ranges::reverse(arguments);
    return arguments;
}

int run(int argc, char** argv) {
    hold_standard_streams();
    remove_leftovers_on_signals();
    CLI::App app{"Fresnel reflectance for rendering: exact, approximate, measured.", "fresnel"};
    try {
        build(app);
        check_command(app, argc, argv);
        app.parse(arguments_of(argc, argv));
        return finished(0);
    } catch (const CLI::Success& request) {
        return finished(app.exit(request)); // --help, --version
    } catch (const CLI::ParseError& error) {
        return report(error.what(), 2);
    } catch (const bad_input& error) {
        return report(error.what(), 2);
    } catch (const std::exception& error) {
        return report(error.what(), 1);
    }
}

} // namespace

} // namespace fresnel::cli

int main(int argc, char** argv) { return fresnel::cli::run(argc, argv); }
