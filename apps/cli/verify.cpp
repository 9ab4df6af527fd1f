#include "commands.hpp"
#include "verify_options.hpp"

#include "conform/verify.hpp"
#include "error.hpp"
#include "figure/page.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace fresnel::cli {

namespace {

using emit::verify_result;

constexpr std::size_t most_rows = 4'000'000;

nlohmann::json described(const verify_result& r) {
    nlohmann::json one = {{"id", r.what.id},
                          {"name", r.what.name},
                          {"kind", emit::to_string(r.what.kind)},
                          {"receiver", r.receiver},
                          {"inputs", r.found.rows + r.found.open_rows},
                          {"compared", r.found.rows},
                          {"differing", r.found.differing},
                          {"max_difference", r.found.max_difference},
                          {"max_ulp", r.found.max_ulp},
                          {"allowed", r.allowed},
                          {"open_inputs", r.found.open_rows},
                          {"open_differing", r.found.open_differing},
                          {"at", r.found.inputs},
                          {"expected", r.found.expected},
                          {"got", r.found.got},
                          {"passed", r.passed()}};
    return one;
}

std::string failed(const verify_result& r) {
    if (r.passed()) return "";
    if (r.found.rows == 0) return "FAILS: all inputs are open; give more --rows";
    return fmt::format("FAILS at ({}): {}, must be {}", fmt::join(r.found.inputs, ", "),
                       fmt::join(r.found.got, ", "), fmt::join(r.found.expected, ", "));
}

void print_table(const conform::verification& all) {
    for (const std::string& receiver : all.receivers)
        fmt::print("{}\n", receiver);
    print_row("\n{:<34} {:<13} {:>8} {:>9} {:>9} {:>8} {:>8} {:>8} {:>9}", "function", "receiver", "inputs",
              "differing", "largest", "ulp", "allowed", "open", "differing");
    for (const verify_result& r : all.results)
        print_row("{:<34} {:<13} {:>8} {:>9} {:>9.2g} {:>8} {:>8.2g} {:>8} {:>9}  {}", r.what.id, r.receiver,
                  r.found.rows, r.found.differing, r.found.max_difference, r.found.max_ulp, r.allowed,
                  r.found.open_rows, r.found.open_differing, failed(r));
    for (const conform::skipped_receiver& s : all.skipped)
        fmt::print("skipped: {}: {}\n", s.receiver, s.reason);
    fmt::print(
        "\nOpen: something is NaN on the way, of which languages say nothing in min, max, clamp and "
        "comparisons, or "
        "pow is outside its\ndomain; counted apart. Inputs that meet a subnormal number are left out.\n");
}

void print(const verify_options& given, const conform::verification& all) {
    if (!given.json) {
        print_table(all);
        return;
    }
    nlohmann::json results = nlohmann::json::array(), skipped = results;
    for (const verify_result& r : all.results)
        results.push_back(described(r));
    for (const conform::skipped_receiver& s : all.skipped)
        skipped.push_back({{"receiver", s.receiver}, {"reason", s.reason}});
    print_json({{"receivers", all.receivers}, {"results", results}, {"skipped", skipped}});
}

// 0: the default.
std::size_t row_count(const verify_options& given) {
    if (given.rows.empty()) return 0;
    const double rows = parse_number("--rows", given.rows);
    if (!(rows >= 1 && rows <= most_rows) || rows != std::floor(rows))
        throw bad_input(fmt::format("--rows '{}': must be a whole number in [1, {}]", given.rows, most_rows));
    return static_cast<std::size_t>(rows);
}

void check(const verify_options& given) {
    if (!given.dump.empty() && !given.compare.empty())
        throw bad_input("--dump, --compare: only one of the two can be given");
}

} // namespace

void add_verify_options(CLI::App& command, verify_options& given) {
    CLI::Option* const verify = command.add_flag("--verify", given.wanted,
                                                 "run the text on graphics devices, by C compilers and by "
                                                 "nvcc where they are, compare bit by bit with the model");
    for (const char* other : {"--lang", "--fix", "--material", "--name", "--out", "--all", "--write",
                              "--check", "--technique", "--stage", "--space", "--ambient"})
        verify->excludes(command.get_option(other));
    command.add_flag("--json", given.json, "with --verify: JSON")->needs(verify);
    command
        .add_option("--rows", given.rows,
                    "with --verify: inputs of each function (default 270336 of one channel, 65536 of more)")
        ->type_name("N")
        ->needs(verify);
    command
        .add_option("--dump", given.dump,
                    "with --verify: write inputs, expected values and texts for other runners")
        ->type_name("DIR")
        ->needs(verify);
    command.add_option("--compare", given.compare, "with --verify: compare what another runner wrote there")
        ->type_name("DIR")
        ->needs(verify);
}

void run_verify(const verify_options& given, const std::vector<std::string>& models) {
    check(given);
    const std::size_t rows = row_count(given);
    const std::vector<emit::verify_case> cases = emit::verify_cases(models);
    if (!given.dump.empty()) {
        require_writable_folder("--dump", given.dump);
        emit::dump_cases(given.dump, cases, {}, rows);
        fmt::print("{}\n", given.dump);
        return;
    }
    conform::verification all;
    if (!given.compare.empty()) {
        all.results = emit::check_dump(given.compare, cases);
    } else {
        const bool shown = isatty(STDERR_FILENO) != 0;
        all = conform::verify(cases, rows, [shown](std::string_view receiver, std::string_view id) {
            if (shown) say("\r\033[Kverify: {} {}", receiver, id);
        });
        if (shown) say("\r\033[K");
    }
    print(given, all);
    if (!all.passed()) {
        std::fflush(stdout);
        throw failure("--verify: a text does not give what is claimed of it; the table says which");
    }
}

} // namespace fresnel::cli
