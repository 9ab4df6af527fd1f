#include "commands.hpp"

#include "error.hpp"
#include "sources/sources.hpp"

#include <fmt/format.h>

#include <map>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> ids;
    bool json = false, markdown = false, sources = false;
};

void print(const claim& one, const finding& found) {
    fmt::print("{}  [{}]\n  {}\n  {}, {}\n  measured: {}\n", one.id, to_string(found.is), one.text,
               one.document, one.place, found.measured);
    if (!found.domain.empty()) fmt::print("  domain:   {}\n", found.domain);
    fmt::print("\n");
}

// The two documents are printed whole.
void check(const options& given) {
    if (given.json + given.markdown + given.sources > 1)
        throw bad_input("--json, --markdown, --sources: give one of them");
    if (!given.ids.empty() && (given.markdown || given.sources))
        throw bad_input(fmt::format("ID '{}': does not go with {}, which prints all", given.ids.front(),
                                    given.markdown ? "--markdown" : "--sources"));
}

void run(const options& given) {
    check(given);
    if (given.sources) return fmt::print("{}", sources_markdown());
    if (given.markdown) return fmt::print("{}", claims_markdown());
    std::vector<const claim*> wanted;
    for (const std::string& id : given.ids)
        wanted.push_back(&find_claim(id));
    if (given.ids.empty())
        for (const claim& one : claims())
            wanted.push_back(&one);

    nlohmann::json all = nlohmann::json::array();
    std::map<std::string_view, int> count;
    for (const claim* one : wanted) {
        const finding found = one->measure();
        ++count[to_string(found.is)];
        if (given.json)
            all.push_back(to_json(*one, found));
        else
            print(*one, found);
    }
    if (given.json) return print_json(all);
    for (const auto& [verdict, number] : count)
        fmt::print("{} {}\n", number, verdict);
}

} // namespace

void add_claims(CLI::App& app) {
    CLI::App* command = add_command(app, "claims", "What five texts claim about Fresnel, measured and judged",
                                    "  fresnel claims\n"
                                    "  fresnel claims wloka-schlick lagarde-range\n"
                                    "  fresnel claims --json\n"
                                    "  fresnel claims --markdown           docs/claims.md\n"
                                    "  fresnel claims --sources            docs/sources.md, item by item");
    const auto given = std::make_shared<options>();
    command->add_option("ID", given->ids, "claims; all if none is named");
    command->add_flag("--json", given->json, "print JSON");
    command->add_flag("--markdown", given->markdown, "print the ledger as Markdown");
    command->add_flag("--sources", given->sources,
                      "print where each item of the texts is found here, as Markdown");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
