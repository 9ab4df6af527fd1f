// Writes data/materials/NAME.txt for every material of a list, from the pages of the refractiveindex.info
// database. Numbers keep the digits they were published with.

#include "error.hpp"
#include "materials/page.hpp"
#include "materials/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>

namespace {

using namespace fresnel;

/// An entry of the list.
struct recipe {
    std::string name, aliases, category, page, k_page, quality;
};

void set_field(recipe& entry, std::string_view line, const std::string& file, int number) {
    const std::pair<std::string_view, std::string*> fields[] = {
        {"name: ", &entry.name}, {"aliases: ", &entry.aliases}, {"class: ", &entry.category},
        {"page: ", &entry.page}, {"k-page: ", &entry.k_page},   {"quality: ", &entry.quality}};
    for (const auto& [key, value] : fields)
        if (line.starts_with(key)) return void(*value = line.substr(key.size()));
    throw bad_input(fmt::format("{}:{}: '{}' is not a field of a material", file, number, line));
}

std::vector<recipe> read_list(const std::string& file) {
    std::vector<recipe> entries;
    bool inside = false;
    for_each_line(read_text_file(file), [&](std::string_view line, int number) {
        if (line.starts_with('#')) return;
        if (!line.empty() && !inside) entries.emplace_back();
        inside = !line.empty();
        if (inside) set_field(entries.back(), line, file, number);
    });
    return entries;
}

/// A row of a page as its text, the wavelength in nanometres.
///
/// position   which row of the page it is
struct text_row {
    std::string wavelength_nm;
    std::vector<std::string> values;
    std::size_t position;
};

double value_of(const std::string& text) { return parse_number(text).value(); }

/// The mean of rows of one wavelength, each number at the fewest digits that give it back.
text_row mean_of(const std::vector<text_row>& rows) {
    text_row mean = rows.front();
    for (std::size_t column = 0; column < mean.values.size(); ++column) {
        double sum = 0;
        for (const text_row& row : rows)
            sum += value_of(row.values[column]);
        mean.values[column] = fmt::format("{}", sum / static_cast<double>(rows.size()));
    }
    return mean;
}

std::vector<text_row> rows_of(const page_block& block, bool only_k) {
    std::vector<text_row> rows;
    for_each_line(block.text, [&](std::string_view line, int) {
        const std::vector<std::string_view> cells = words(line);
        if (cells.empty()) return;
        const auto first = only_k ? cells.end() - 1 : cells.begin() + 1;
        rows.push_back({nanometres(cells[0]), {first, cells.end()}, rows.size()});
    });
    std::ranges::sort(
        rows, {}, [](const text_row& row) { return std::pair(value_of(row.wavelength_nm), row.position); });
    return rows;
}

/// One row for each wavelength, as the page's reader has it.
std::vector<text_row> merged(const std::vector<text_row>& rows) {
    std::vector<text_row> result;
    for (std::size_t i = 0; i < rows.size();) {
        std::vector<text_row> same;
        for (const double nm = value_of(rows[i].wavelength_nm);
             i < rows.size() && value_of(rows[i].wavelength_nm) == nm; ++i)
            same.push_back(rows[i]);
        result.push_back(same.size() == 1 ? same.front() : mean_of(same));
    }
    return result;
}

std::string written_table(const page_block& block, bool only_k) {
    const std::string_view what = only_k ? "k" : std::string_view(block.type).substr(10);
    const std::vector<text_row> rows = merged(rows_of(block, only_k));
    std::size_t width = 0, value_width = 0;
    for (const text_row& row : rows) {
        width = std::max(width, row.wavelength_nm.size());
        value_width = std::max(value_width, row.values.front().size());
    }
    std::string text = fmt::format("\n{}\n", what == "nk" ? "n k" : what);
    for (const text_row& row : rows) {
        text += fmt::format("{:<{}}  {}", row.wavelength_nm, width, row.values.front());
        if (row.values.size() > 1)
            text += fmt::format("{:{}}  {}", "", value_width - row.values.front().size(), row.values.back());
        text += '\n';
    }
    return text;
}

/// The coefficients: of a sum of pairs, one pair a line; of the others, all on one.
std::string written_formula(const page_block& block) {
    const std::vector<std::string_view> c = words(block.text), ends = words(block.range);
    const int formula = block.type.back() - '0';
    const bool in_pairs = formula <= 6 && formula != 4;
    std::string text =
        fmt::format("\nn {} {} to {} nm\n", block.type, nanometres(ends[0]), nanometres(ends[1]));
    for (std::size_t i = 0; i < c.size(); ++i) {
        const bool ends_line = i + 1 == c.size() || (in_pairs && i % 2 == 0);
        text += fmt::format("{}{}", c[i], ends_line ? "\n" : "  ");
    }
    return text;
}

std::string written(const page_block& block) {
    return block.type.starts_with("formula") ? written_formula(block) : written_table(block, false);
}

/// The k of a page that a material takes only k from.
std::string written_k(const page& source) {
    for (const page_block& block : source.blocks)
        if (block.type == "tabulated nk" || block.type == "tabulated k") return written_table(block, true);
    throw bad_input("the k page has no tabulated k");
}

/// The citation of a page: its references without remarks in square brackets.
std::string citation_of(const page& source) {
    std::string text = source.references;
    for (std::size_t open; (open = text.find('[')) != std::string::npos;) {
        const std::size_t close = text.find(']', open);
        if (close == std::string::npos) break;
        text.erase(open, close + 1 - open);
    }
    while (text.ends_with('.') || text.ends_with(' '))
        text.pop_back();
    return plain_text(text) + ".";
}

/// "14 points in 380-780 nm", or the formula's range.
std::string extent_of(const material& what) {
    if (const auto* law = std::get_if<dispersion>(&*what.n))
        return fmt::format("formula for {}-{} nm", law->lo_nm, law->hi_nm);
    const auto& at = std::get<samples>(*what.n).wavelength_nm;
    const auto visible = std::ranges::count_if(at, [](double nm) { return nm >= 380 && nm <= 780; });
    return fmt::format("{} points in 380-780 nm", visible);
}

std::string gaps_of(const material& what) {
    const auto [lo, hi] = what.range_nm;
    std::string text;
    if (lo > 380) text += fmt::format("; held constant below {} nm", lo);
    if (hi < 780) text += fmt::format("; held constant above {} nm", hi);
    return what.k ? text : text + "; k not given";
}

std::string quality_of(const recipe& entry, const page& source, const page* k_source) {
    material what;
    what.n = source.n, what.k = k_source ? k_source->k : source.k;
    what.range_nm = known_range(what);
    std::string text = entry.quality + "; " + extent_of(what) + gaps_of(what);
    std::set<std::string> remarks(source.diagnostics.begin(), source.diagnostics.end());
    for (const std::string& remark : remarks)
        text += "; " + remark;
    return text + ".";
}

std::string file_of(const recipe& entry, const std::string& database) {
    const auto read = [&](const std::string& name) {
        return read_page_file(database + "/data/" + name + ".yml");
    };
    const page source = read(entry.page);
    std::optional<page> k_source;
    if (!entry.k_page.empty()) k_source = read(entry.k_page);

    std::string citation = citation_of(source);
    if (k_source) citation = fmt::format("n: {} k: {}", citation, citation_of(*k_source));
    std::string text = "name: " + entry.name + "\n";
    const auto add = [&](std::string_view key, const std::string& value) {
        if (!value.empty()) text += fmt::format("{}: {}\n", key, value);
    };
    add("aliases", entry.aliases), add("class", entry.category), add("page", entry.page),
        add("k-page", entry.k_page);
    add("citation", citation), add("doi", source.doi), add("licence", "CC0 1.0");
    add("quality", quality_of(entry, source, k_source ? &*k_source : nullptr));
    for (const page_block& block : source.blocks)
        text += written(block);
    return k_source ? text + written_k(*k_source) : text;
}

/// Written beside and renamed, so that an interrupted run leaves no half of a file; not at all where nothing
/// changes, so that nothing is rebuilt.
void write_file(const std::filesystem::path& path, const std::string& text) {
    if (std::filesystem::exists(path) && read_text_file(path.string()) == text) return;
    const std::filesystem::path beside = path.string() + ".new";
    std::ofstream out(beside, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw failure(fmt::format("cannot write '{}'", beside.string()));
    std::filesystem::rename(beside, path);
}

void remove_others(const std::filesystem::path& folder, const std::set<std::string>& kept) {
    std::vector<std::filesystem::path> gone;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".txt" && !kept.contains(entry.path().filename().string()))
            gone.push_back(entry.path());
    for (const auto& path : gone)
        std::filesystem::remove(path);
}

void make_data(const std::string& database, const std::string& list, const std::filesystem::path& folder) {
    std::vector<std::pair<std::string, std::string>> files;
    for (const recipe& entry : read_list(list))
        files.emplace_back(entry.name + ".txt", file_of(entry, database));
    std::set<std::string> kept;
    for (const auto& [name, text] : files)
        write_file(folder / name, text), kept.insert(name);
    remove_others(folder, kept);
    fmt::print("{} materials written to {}\n", kept.size(), folder.string());
}

} // namespace

int main(int count, char** arguments) {
    if (count != 4) {
        fmt::print(stderr, "usage: fresnel_make_data DATABASE LIST FOLDER\n");
        return 2;
    }
    try {
        make_data(arguments[1], arguments[2], arguments[3]);
    } catch (const bad_input& error) {
        fmt::print(stderr, "fresnel_make_data: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "fresnel_make_data: {}\n", error.what());
        return 1;
    }
}
