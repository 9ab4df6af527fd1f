#include "colour_options.hpp"
#include "commands.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/drawing.hpp"
#include "analysis/report.hpp"
#include "figure/page.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <set>
#include <unistd.h>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> names;
    colour_options colour;
    std::string out;
    bool json = false;
};

void print_rank(const model_fit& m, bool recommended) {
    const auto three = [](const std::array<double, 3>& v) {
        return fmt::format("{:.4f} {:.4f} {:.4f}", v[0], v[1], v[2]);
    };
    const cost_row* cost = find_cost(m.name);
    print_row("{:>4} {:<20} {:>22} {:>22} {:>8.2f} {:>6} {:>6} {}", m.rank, m.name, three(m.error.max),
              three(m.error.cosine), m.error.delta_e_max, m.cost,
              cost == nullptr ? "" : fmt::format("{:.0f}", cost->instructions),
              recommended ? "<- use this" : "");
}

void print(const comparison& result) {
    const normal_colour& c = result.colour;
    print_row("{}  F0 {:.4f} {:.4f} {:.4f}  {}", c.material, c.f0[0], c.f0[1], c.f0[2], c.page);
    fmt::print("{}\n\n", verdict(result));
    const std::string channels = fmt::format("{}", fmt::join(channel_letters(c.space), " "));
    fmt::print("{:>4} {:<20} {:>22} {:>22} {:>8} {:>6} {:>6}\n", "rank", "model", "max error " + channels,
               "cosine error " + channels, "delta E", "cost", "instr");
    for (const model_fit& m : result.models)
        print_rank(m, &m == &result.best_choice());
    fmt::print("{}, ambient {}\n\n", c.recipe, c.ambient);
}

// One line on a terminal that is overwritten; nothing where the output is a file.
void progress(std::size_t done, std::size_t count, std::string_view what) {
    if (isatty(STDERR_FILENO) != 0) say("\r\033[Kcompare: {}/{} {}", done, count, what);
    if (isatty(STDERR_FILENO) != 0 && done == count) say("\n");
}

void run(const options& given) {
    const color_space space = chosen_space(given.colour);
    const double ambient = chosen_ambient(given.colour);
    std::vector<material> substances;
    std::set<std::string> seen; // a material by whichever of its names, a file by its path
    for (const std::string& name : given.names) {
        const bool file = name.ends_with(".yml") || name.ends_with(".csv");
        material one = load_material(name);
        if (seen.insert(file ? name : one.name).second) substances.push_back(std::move(one));
    }
    if (!given.out.empty()) require_writable_folder("--out", given.out);

    std::vector<report_entry> entries;
    for (const material& substance : substances) {
        progress(entries.size(), substances.size(), substance.name);
        entries.push_back({substance, compare(substance, space, ambient)});
    }
    progress(entries.size(), substances.size(), given.out.empty() ? "done" : "drawing the figures");
    if (!given.out.empty()) write_report(entries, given.out);
    if (given.json) return print_json(report_json(entries));
    if (given.out.empty())
        for (const report_entry& entry : entries)
            print(entry.result);
    else
        for (const report_entry& entry : entries)
            fmt::print("{:<12} {}\n", entry.substance.name, verdict(entry.result));
    if (!given.out.empty()) fmt::print("wrote {0}/index.html, {0}/report.json and {0}/figures/\n", given.out);
}

} // namespace

void add_compare(CLI::App& app) {
    CLI::App* command = add_command(
        app, "compare", "Which approximation to use for a material, and what it loses",
        "  fresnel compare copper\n"
        "  fresnel compare copper gold n-bk7 --out out     a report with figures\n"
        "  fresnel compare gold --space acescg --json\n"
        "  fresnel compare water --ambient 1.5\n\n"
        "cost is in operations, all three channels; instr in instructions of one channel on AMD's navi21\n"
        "(`fresnel cost`); delta E is CIEDE2000 at the worst angle.");
    const auto given = std::make_shared<options>();
    command->add_option("NAME", given->names, "materials, see `fresnel materials`")->required();
    add_colour_options(*command, given->colour);
    command->add_option("--out", given->out, "write index.html, report.json and figures/ into this folder")
        ->type_name("DIR");
    command->add_flag("--json", given->json, "print the content of report.json");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
