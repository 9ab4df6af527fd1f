#include "materials/table.hpp"

#include "error.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>

namespace fresnel {
namespace {

constexpr std::size_t largest_file = 16 << 20;

/// A place in a text that is being read; `fail` reports it as "FILE:LINE: " or "FILE:LINE:COLUMN: ".
struct place {
    const std::string& file;
    int line;
    int column = 0;

    template <class... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> message, Args&&... args) const {
        const std::string at = column > 0 ? fmt::format(":{}", column) : "";
        throw bad_input(
            fmt::format("{}:{}{}: {}", file, line, at, fmt::format(message, std::forward<Args>(args)...)));
    }
};

struct cell {
    std::string text;
    int column;
};

/// The cells of a CSV line; a cell that begins with a double quote ends at the next single one.
std::vector<cell> csv_cells(std::string_view line, place at) {
    std::vector<cell> cells;
    for (std::size_t i = 0;; ++i) {
        cell next{"", static_cast<int>(i) + 1};
        const bool quoted = i < line.size() && line[i] == '"';
        bool open = quoted;
        if (quoted) ++i;
        for (; i < line.size() && (quoted || line[i] != ','); ++i) {
            if (quoted && line[i] == '"' && (++i >= line.size() || line[i] != '"')) {
                open = false;
                break;
            }
            next.text += line[i];
        }
        if (open) place{at.file, at.line, next.column}.fail("a quote is not closed");
        if (i < line.size() && line[i] != ',')
            place{at.file, at.line, static_cast<int>(i) + 1}.fail(
                "'{}' follows a closing quote; a comma must", line[i]);
        cells.push_back(std::move(next));
        if (i >= line.size()) return cells;
    }
}

bool is_remark(std::string_view line) { return trimmed(line).empty() || trimmed(line).front() == '#'; }

std::string_view without_byte_order_mark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

double number(std::string_view text, std::string_view what, const place& at) {
    const std::optional<double> value = parse_number(text);
    if (!value) at.fail("{} '{:.40}' is not a number", what, text);
    return *value;
}

/// The order of the table's wavelengths, rows of equal ones staying as they were.
std::vector<std::size_t> order_of(const std::vector<double>& wavelength_nm) {
    std::vector<std::size_t> order(wavelength_nm.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(wavelength_nm[i], i); });
    return order;
}

std::vector<double> picked(const std::vector<double>& from, const std::vector<std::size_t>& order) {
    std::vector<double> result;
    for (const std::size_t i : order)
        result.push_back(from[i]);
    return result;
}

/// Rows of one wavelength become one, with their mean; returns how many went.
std::size_t merge_repeated(samples& table) {
    std::vector<double>&w = table.wavelength_nm, &v = table.value;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < w.size();) {
        const double at = w[i];
        double sum = 0;
        std::size_t count = 0;
        for (; i < w.size() && w[i] == at; ++i, ++count)
            sum += v[i];
        w[kept] = at, v[kept] = sum / static_cast<double>(count), ++kept;
    }
    const std::size_t gone = w.size() - kept;
    w.resize(kept), v.resize(kept);
    return gone;
}

/// The ends of a spectrum's range.
std::array<double, 2> range_of(const spectrum& quantity) {
    if (const auto* law = std::get_if<dispersion>(&quantity)) return {law->lo_nm, law->hi_nm};
    const auto& table = std::get<samples>(quantity);
    return {table.wavelength_nm.front(), table.wavelength_nm.back()};
}

// ---- a user's table -------------------------------------------------------------------------------------------

struct csv_columns {
    int wavelength = -1, n = -1, k = -1, count = 0;
};

csv_columns read_header(std::string_view line, const place& at) {
    csv_columns columns;
    for (const cell& c : csv_cells(line, at)) {
        const std::string_view name = trimmed(c.text);
        int* column = name == "wavelength_nm" ? &columns.wavelength
                      : name == "n"           ? &columns.n
                      : name == "k"           ? &columns.k
                                              : nullptr;
        const place here{at.file, at.line, c.column};
        if (!column)
            here.fail("column '{:.40}' is unknown; the header is wavelength_nm,n or wavelength_nm,n,k", name);
        if (*column >= 0) here.fail("column '{}' is given twice", name);
        *column = columns.count++;
    }
    if (columns.wavelength < 0 || columns.n < 0)
        at.fail("the header must name the columns wavelength_nm and n, and may name k");
    return columns;
}

struct csv_row {
    double wavelength_nm, n, k;
    int line;
};

csv_row read_row(std::string_view line, const csv_columns& columns, const place& at) {
    const std::vector<cell> cells = csv_cells(line, at);
    if (static_cast<int>(cells.size()) != columns.count)
        at.fail("{} cells; the header has {}", cells.size(), columns.count);
    const auto value = [&](int column, const char* what) {
        const cell& c = cells[static_cast<std::size_t>(column)];
        const place here{at.file, at.line, c.column};
        const double x = number(trimmed(c.text), what, here);
        if (column == columns.wavelength ? x <= 0 : x < 0 || x > largest_index)
            here.fail("{} is {}; it must be {}", what, trimmed(c.text),
                      column == columns.wavelength ? "above 0" : fmt::format("in [0, {}]", largest_index));
        return x;
    };
    const csv_row row{value(columns.wavelength, "wavelength_nm"), value(columns.n, "n"),
                      columns.k < 0 ? 0 : value(columns.k, "k"), at.line};
    if (row.n == 0 && row.k == 0) at.fail("n and k are both 0, the index of nothing; one must be above 0");
    return row;
}

void refuse_repeated(const std::vector<csv_row>& rows, const std::string& file) {
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].wavelength_nm == rows[i - 1].wavelength_nm)
            place{file, std::max(rows[i].line, rows[i - 1].line)}.fail(
                "wavelength_nm {} was given before, in line {}", rows[i].wavelength_nm,
                std::min(rows[i].line, rows[i - 1].line));
}

// ---- the files of data/materials ------------------------------------------------------------------------------

std::vector<std::string> list_of(std::string_view text, char separator) {
    std::vector<std::string> items;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        items.emplace_back(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return items;
}

/// One block of a material file: its first line and the numbers below it, row after row.
///
/// columns   how many numbers a row must have; 0 for any number of them
struct number_block {
    std::string_view heading;
    int line;
    std::size_t columns;
    std::vector<double> numbers;
};

number_block opened(std::string_view heading, const place& at) {
    if (heading == "n k") return {heading, at.line, 3, {}};
    if (heading == "n" || heading == "k") return {heading, at.line, 2, {}};
    if (heading.starts_with("n formula ")) return {heading, at.line, 0, {}};
    at.fail("'{:.40}' is not a block; n k, n, k and n formula are", heading);
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Appends the numbers of a line. Tables are most of the data, so this is the loop that start-up waits for.
void append_numbers(number_block& block, std::string_view line, const place& at) {
    const char* const end = line.data() + line.size();
    std::size_t count = 0;
    for (const char* next = line.data();; ++count) {
        while (next != end && is_blank(*next))
            ++next;
        if (next == end) break;
        double value = 0;
        const auto [after, error] = std::from_chars(next, end, value);
        if (error != std::errc() || !std::isfinite(value) || (after != end && !is_blank(*after)))
            at.fail("'{:.40}' is not a row of numbers", line);
        block.numbers.push_back(value), next = after;
    }
    if (block.columns > 0 && count != block.columns)
        at.fail("{} numbers; a row of '{}' has {}", count, block.heading, block.columns);
}

samples column_of(const number_block& block, std::size_t column, const std::string& file) {
    samples table;
    const std::size_t rows = block.numbers.size() / block.columns;
    table.wavelength_nm.reserve(rows), table.value.reserve(rows);
    for (std::size_t i = 0; i < block.numbers.size(); i += block.columns) {
        const double nm = block.numbers[i];
        if (i > 0 && nm <= table.wavelength_nm.back())
            place{file, block.line}.fail("wavelengths of '{}' must increase; {} nm does not", block.heading,
                                         nm);
        table.wavelength_nm.push_back(nm), table.value.push_back(block.numbers[i + column]);
    }
    return table;
}

dispersion law_of(const number_block& block, const std::string& file) {
    const std::vector<std::string_view> w = words(block.heading); // n formula F LO to HI nm
    const place here{file, block.line};
    if (w.size() != 7 || w[4] != "to" || w[6] != "nm")
        here.fail("'{}' must read 'n formula NUMBER LO to HI nm'", block.heading);
    const double formula = number(w[2], "formula", here);
    const double lo = number(w[3], "range", here), hi = number(w[5], "range", here);
    if (!(formula >= 1 && formula <= 9) || !(lo > 0 && lo <= hi))
        here.fail("'{}' must have a formula of 1 to 9 and a range that increases from above 0",
                  block.heading);
    return {static_cast<int>(formula), block.numbers, lo, hi};
}

void add_block(material& what, const number_block& block, const std::string& file) {
    if (block.numbers.empty()) place{file, block.line}.fail("'{}' is followed by no numbers", block.heading);
    if (block.columns == 0)
        what.n = law_of(block, file);
    else if (block.heading == "k")
        what.k = column_of(block, 1, file);
    else
        what.n = column_of(block, 1, file);
    if (block.columns == 3) what.k = column_of(block, 2, file);
}

void add_field(material& what, std::string_view line, const place& at) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) at.fail("'{:.40}' is not 'key: value'", line);
    const std::string_view key = line.substr(0, colon);
    const std::string value(trimmed(line.substr(colon + 2)));
    const std::map<std::string_view, std::string*> texts = {
        {"name", &what.name},         {"class", &what.category}, {"page", &what.page},
        {"citation", &what.citation}, {"doi", &what.doi},        {"licence", &what.licence},
        {"quality", &what.quality}};
    if (const auto text = texts.find(key); text != texts.end())
        *text->second = value;
    else if (key == "aliases")
        what.aliases = list_of(value, ',');
    else if (key != "k-page")
        at.fail("key '{:.40}' is unknown", key);
}

bool begins_number(std::string_view line) {
    return !line.empty() && (std::isdigit(static_cast<unsigned char>(line[0])) || line[0] == '-');
}

} // namespace

std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

bool begins_utf_16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view white = " \t\r\n";
    const std::size_t first = text.find_first_not_of(white);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::vector<std::string_view> words(std::string_view text) {
    constexpr std::string_view white = " \t\r\n";
    std::vector<std::string_view> result;
    for (std::size_t i = text.find_first_not_of(white); i != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(white, i), text.size());
        result.push_back(text.substr(i, end - i));
        i = text.find_first_not_of(white, end);
    }
    return result;
}

void for_each_line(std::string_view text, const std::function<void(std::string_view, int)>& use) {
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        use(line, number);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::string read_text_file(const std::string& path) {
    if (is_folder(path)) throw bad_input(fmt::format("'{}' is a folder; a file is needed", path));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw bad_input(fmt::format("file '{}' cannot be opened", path));
    std::string text;
    // One byte beyond the limit is enough to know; a device or a pipe has no size to ask for.
    for (char buffer[1 << 16]; text.size() <= largest_file && file;) {
        file.read(buffer, sizeof buffer);
        text.append(buffer, static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) throw bad_input(fmt::format("file '{}' cannot be read", path));
    if (text.size() > largest_file)
        throw bad_input(fmt::format("file '{}' is above 16 MiB, too large for a table", path));
    return text;
}

samples sorted_samples(samples rows, std::string_view what, std::vector<std::string>& diagnostics) {
    if (!std::ranges::is_sorted(rows.wavelength_nm)) {
        diagnostics.push_back(fmt::format("{}: wavelengths out of order, sorted", what));
        const std::vector<std::size_t> order = order_of(rows.wavelength_nm);
        rows = {picked(rows.wavelength_nm, order), picked(rows.value, order)};
    }
    if (const std::size_t gone = merge_repeated(rows); gone > 0)
        diagnostics.push_back(
            fmt::format("{}: {} repeated wavelength{}, averaged", what, gone, gone > 1 ? "s" : ""));
    return rows;
}

std::array<double, 2> known_range(const material& what) {
    const std::array<double, 2> n = range_of(*what.n), k = what.k ? range_of(*what.k) : n;
    const std::array<double, 2> both = {std::max(n[0], k[0]), std::min(n[1], k[1])};
    return both[0] <= both[1] ? both : n;
}

std::string guessed_class(const material& what) {
    const optical_index at = index_at(what, 550);
    return at.k > 1 ? "metal" : at.n > 3 ? "semiconductor" : "dielectric";
}

material read_csv_material(std::string_view csv, const std::string& file) {
    std::optional<csv_columns> columns;
    std::vector<csv_row> rows;
    if (begins_utf_16(csv)) place{file, 1, 1}.fail("is UTF-16; save it as UTF-8");
    for_each_line(without_byte_order_mark(csv), [&](std::string_view line, int number) {
        if (is_remark(line)) return;
        const place at{file, number};
        if (!columns)
            columns = read_header(line, at);
        else
            rows.push_back(read_row(line, *columns, at));
    });
    if (!columns)
        throw bad_input(fmt::format("{}: is empty; its first line must be wavelength_nm,n,k", file));
    if (rows.empty()) throw bad_input(fmt::format("{}: has a header but no rows", file));
    std::ranges::sort(rows, {}, [](const csv_row& row) { return std::pair(row.wavelength_nm, row.line); });
    refuse_repeated(rows, file);

    samples n, k;
    for (const csv_row& row : rows) {
        n.wavelength_nm.push_back(row.wavelength_nm), n.value.push_back(row.n);
        k.wavelength_nm.push_back(row.wavelength_nm), k.value.push_back(row.k);
    }
    material what;
    what.name = file;
    what.n = n;
    if (columns->k >= 0) what.k = k;
    what.range_nm = known_range(what);
    what.category = guessed_class(what);
    what.citation = file, what.licence = "not stated";
    what.quality = fmt::format("User's table of {} rows over {}-{} nm.", rows.size(), what.range_nm[0],
                               what.range_nm[1]);
    return what;
}

material read_material(std::string_view text, const std::string& file) {
    material what;
    std::optional<number_block> block;
    const auto close = [&] {
        if (block) add_block(what, *block, file);
        block.reset();
    };
    bool header = true;
    for_each_line(text, [&](std::string_view line, int number) {
        const place at{file, number};
        if (line.empty())
            header = false;
        else if (header)
            add_field(what, line, at);
        else if (!begins_number(line))
            close(), block = opened(line, at);
        else if (block)
            append_numbers(*block, line, at);
        else
            at.fail("numbers must follow a line that says what they are");
    });
    close();
    if (!what.n) throw bad_input(fmt::format("{}: has no n", file));
    what.range_nm = known_range(what);
    return what;
}

std::vector<material> read_material_rows(std::string_view csv, material_kind kind, const std::string& file) {
    std::vector<material> rows;
    for_each_line(csv, [&](std::string_view line, int number_of_line) {
        if (is_remark(line) || line.starts_with("name,")) return;
        const place at{file, number_of_line};
        const std::vector<cell> c = csv_cells(line, at);
        if (c.size() != 8) at.fail("{} cells; there must be 8", c.size());
        material row;
        row.name = c[0].text, row.aliases = list_of(c[1].text, ';'), row.category = c[2].text,
        row.kind = kind;
        std::array<double, 2>& ends = kind == material_kind::index ? row.index : row.f0;
        ends[0] = number(c[3].text, "lo", at), ends[1] = number(c[4].text, "hi", at);
        row.licence = c[5].text, row.citation = c[6].text, row.quality = c[7].text;
        row.range_nm = {380, 780};
        rows.push_back(std::move(row));
    });
    return rows;
}

} // namespace fresnel
