#include "commands.hpp"

#include "error.hpp"
#include "sources/sources.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> ids;
    std::string out;
    bool list = false, json = false;
};

void print_list(bool json) {
    nlohmann::json all = nlohmann::json::array();
    for (const source_figure& one : source_figures()) {
        if (json)
            all.push_back({{"id", one.id}, {"source", one.source}, {"title", one.title}});
        else
            fmt::print("{:<26} {}\n", one.id, one.title);
    }
    if (json) print_json(all);
}

// A figure in words: its published numbers beside ours.
void print_checks(const source_figure& entry, const regenerated& made) {
    fmt::print("{}  {}\n  {}\n", entry.id, entry.title, made.measured);
    for (const check& c : made.checks)
        print_row("  {:<44} {:>10.6g} {:>10.6g} {:>+10.2g} {}", c.what, c.published, c.computed,
                  c.difference(), c.matched() ? "" : c.why);
}

void run(const options& given) {
    if (given.list && !given.ids.empty())
        throw bad_input(fmt::format("ID '{}': does not go with --list, which names all", given.ids.front()));
    if (given.list && !given.out.empty())
        throw bad_input(fmt::format("--out '{}': does not go with --list, which writes nothing", given.out));
    if (given.list) return print_list(given.json);
    std::vector<const source_figure*> wanted;
    for (const std::string& id : given.ids)
        wanted.push_back(&find_source_figure(id));
    if (given.ids.empty())
        for (const source_figure& one : source_figures())
            wanted.push_back(&one);
    if (given.ids.empty() && given.out.empty())
        throw bad_input("--out: must name the folder to write into (or name figures to print, or --list)");
    if (!given.out.empty()) {
        if (isatty(STDERR_FILENO) != 0) say("figures: drawing {}\n", wanted.size());
        write_source_figures(wanted, given.out);
    }
    nlohmann::json all = nlohmann::json::array();
    for (const source_figure* entry : wanted) {
        if (given.json)
            all.push_back(to_json(*entry, entry->make()));
        else if (given.out.empty())
            print_checks(*entry, entry->make());
    }
    if (given.json) return print_json(all);
    if (!given.out.empty())
        fmt::print("wrote {} figures as svg, png and json, and {}/index.html\n", wanted.size(), given.out);
}

} // namespace

void add_figures(CLI::App& app) {
    CLI::App* command = add_command(
        app, "figures", "The figures and tables of five texts on Fresnel, regenerated and checked",
        "  fresnel figures --list\n"
        "  fresnel figures --out out/figures          all of them, with index.html to read\n"
        "  fresnel figures wloka-4 rtr4-table-9-2 --out out\n"
        "  fresnel figures rtr4-table-9-2             published and computed numbers");
    const auto given = std::make_shared<options>();
    command->add_option("ID", given->ids, "figures, see --list; all if none is named");
    command->add_option("--out", given->out, "write ID.svg, ID.png, ID.json and index.html here")
        ->type_name("DIR");
    command->add_flag("--list", given->list, "list the figures");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
