#include "materials/page.hpp"

#include "error.hpp"
#include "materials/table.hpp"

#include <fmt/format.h>
#include <yaml.h>

#include <algorithm>
#include <filesystem>
#include <span>

namespace fresnel {
namespace {

// ---- YAML events ----------------------------------------------------------------------------------------------

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
    throw bad_input(fmt::format("{}:{}: {}", file, line, message));
}

int line_at(std::string_view text, std::size_t offset) {
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, std::min(offset, text.size())), '\n'));
}

/// The events of one YAML text, one at a time.
class events {
public:
    events(std::string_view text, const std::string& file) : text_(text), file_(file) {
        if (!yaml_parser_initialize(&parser_)) throw failure("out of memory");
        yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                     text.size());
    }
    ~events() {
        yaml_event_delete(&event_);
        yaml_parser_delete(&parser_);
    }
    events(const events&) = delete;
    events& operator=(const events&) = delete;

    yaml_event_type_t next() {
        yaml_event_delete(&event_);
        if (!yaml_parser_parse(&parser_, &event_)) fail_in_parser();
        if (event_.type == YAML_ALIAS_EVENT) stop("an alias; a page may not use them");
        return event_.type;
    }
    yaml_event_type_t type() const { return event_.type; }

    std::string_view scalar() const {
        return {reinterpret_cast<const char*>(event_.data.scalar.value), event_.data.scalar.length};
    }

    /// Where the event's content begins: below the mark of a block scalar, otherwise at it.
    int line() const {
        const bool block =
            event_.type == YAML_SCALAR_EVENT && (event_.data.scalar.style == YAML_LITERAL_SCALAR_STYLE ||
                                                 event_.data.scalar.style == YAML_FOLDED_SCALAR_STYLE);
        return static_cast<int>(event_.start_mark.line) + (block ? 2 : 1);
    }

    [[noreturn]] void stop(const std::string& message) const { fail(file_, line(), message); }

private:
    [[noreturn]] void fail_in_parser() const {
        const bool in_bytes = parser_.error == YAML_READER_ERROR;
        const int line = in_bytes ? line_at(text_, parser_.problem_offset)
                                  : static_cast<int>(parser_.problem_mark.line) + 1;
        fail(file_, line, fmt::format("not YAML: {}", parser_.problem ? parser_.problem : "unreadable"));
    }

    std::string_view text_;
    const std::string& file_;
    yaml_parser_t parser_{};
    yaml_event_t event_{};
};

/// Leaves the value that the current event begins, whatever is in it.
void skip(events& yaml) {
    for (int depth = 0;;) {
        const yaml_event_type_t type = yaml.type();
        depth += type == YAML_MAPPING_START_EVENT || type == YAML_SEQUENCE_START_EVENT;
        depth -= type == YAML_MAPPING_END_EVENT || type == YAML_SEQUENCE_END_EVENT;
        if (depth == 0) return;
        yaml.next();
    }
}

std::string text_value(events& yaml, std::string_view key) {
    if (yaml.type() != YAML_SCALAR_EVENT) yaml.stop(fmt::format("{} must be text", key));
    return std::string(yaml.scalar());
}

/// Calls use(key) for each entry of a mapping, the current event then being the first of its value.
template <class Use>
void for_each_entry(events& yaml, std::string_view what, Use use) {
    if (yaml.type() != YAML_MAPPING_START_EVENT)
        yaml.stop(fmt::format("{} must be 'key: value' lines", what));
    while (yaml.next() != YAML_MAPPING_END_EVENT) {
        const std::string key = text_value(yaml, "a key");
        yaml.next();
        use(key);
    }
}

std::map<std::string, std::string> read_texts(events& yaml, std::string_view what) {
    std::map<std::string, std::string> texts;
    if (yaml.type() != YAML_MAPPING_START_EVENT) {
        if (yaml.type() == YAML_SCALAR_EVENT && !yaml.scalar().empty()) texts[""] = plain_text(yaml.scalar());
        return skip(yaml), texts;
    }
    for_each_entry(yaml, what, [&](const std::string& key) {
        if (yaml.type() == YAML_SCALAR_EVENT) texts[key] = plain_text(yaml.scalar());
        skip(yaml);
    });
    return texts;
}

page_block read_block(events& yaml) {
    page_block block;
    const int line = yaml.line();
    for_each_entry(yaml, "a DATA entry", [&](const std::string& key) {
        if (key == "type")
            block.type = text_value(yaml, key);
        else if (key == "wavelength_range")
            block.range = text_value(yaml, key);
        else if (key == "data" || key == "coefficients")
            block.text = text_value(yaml, key), block.line = yaml.line();
        else
            skip(yaml);
    });
    if (block.line == 0) block.line = line;
    return block;
}

std::vector<page_block> read_blocks(events& yaml) {
    if (yaml.type() != YAML_SEQUENCE_START_EVENT) yaml.stop("DATA must be a list of tables and formulas");
    std::vector<page_block> blocks;
    while (yaml.next() != YAML_SEQUENCE_END_EVENT)
        blocks.push_back(read_block(yaml));
    return blocks;
}

// ---- numbers --------------------------------------------------------------------------------------------------

double number(std::string_view word, std::string_view what, const std::string& file, int line) {
    const std::optional<double> value = parse_number(word);
    if (!value) fail(file, line, fmt::format("{} '{:.40}' is not a number", what, word));
    return *value;
}

double wavelength_nm(std::string_view word, const std::string& file, int line) {
    const double um = number(word, "wavelength", file, line);
    if (um <= 0) fail(file, line, fmt::format("wavelength {} um; it must be above 0", word));
    return number(nanometres(word), "wavelength", file, line);
}

double index(std::string_view word, std::string_view what, const std::string& file, int line) {
    const double value = number(word, what, file, line);
    if (std::abs(value) > largest_index)
        fail(file, line, fmt::format("{0} is {1:.40}; it must be in [-{2}, {2}]", what, word, largest_index));
    return value;
}

struct columns {
    samples n, k;
};

void push(samples& table, double nm, double value) {
    table.wavelength_nm.push_back(nm), table.value.push_back(value);
}

columns read_table(const page_block& block, bool has_n, bool has_k, const std::string& file) {
    columns table;
    const std::size_t expected = has_n && has_k ? 3 : 2;
    for_each_line(block.text, [&](std::string_view text, int row) {
        const int line = block.line + row - 1;
        const std::vector<std::string_view> cells = words(text);
        if (cells.empty()) return;
        if (cells.size() != expected)
            fail(file, line,
                 fmt::format("{} numbers; a row of '{}' has {}", cells.size(), block.type, expected));
        const double nm = wavelength_nm(cells[0], file, line);
        if (has_n) push(table.n, nm, index(cells[1], "n", file, line));
        if (has_k) push(table.k, nm, index(cells[expected - 1], "k", file, line));
    });
    if ((has_n ? table.n : table.k).value.empty())
        fail(file, block.line, fmt::format("'{}' has no rows", block.type));
    return table;
}

/// How many coefficients each formula can use.
constexpr std::size_t most_coefficients[] = {0, 17, 17, 17, 17, 11, 11, 6, 4, 6};

dispersion read_formula(const page_block& block, const std::string& file) {
    const int formula = block.type.back() - '0';
    const std::vector<std::string_view> ends = words(block.range), c = words(block.text);
    if (ends.size() != 2)
        fail(file, block.line, fmt::format("'{}' needs a wavelength_range of two numbers", block.type));
    dispersion law{
        formula, {}, wavelength_nm(ends[0], file, block.line), wavelength_nm(ends[1], file, block.line)};
    if (law.lo_nm > law.hi_nm)
        fail(file, block.line, fmt::format("wavelength_range '{}' must increase", block.range));
    const std::size_t most = most_coefficients[formula];
    if (c.empty() || c.size() > most)
        fail(file, block.line,
             fmt::format("{} coefficients; '{}' takes 1 to {}", c.size(), block.type, most));
    for (const std::string_view word : c)
        law.coefficients.push_back(number(word, "coefficient", file, block.line));
    return law;
}

// ---- diagnostics ----------------------------------------------------------------------------------------------

void note_negative(const samples& table, std::string_view what, std::vector<std::string>& diagnostics) {
    const auto below = std::ranges::count_if(table.value, [](double v) { return v < 0; });
    if (below > 0)
        diagnostics.push_back(fmt::format("{}: {} of {} values negative", what, below, table.value.size()));
}

/// The poles that a Sellmeier formula shows in its coefficients, in nm, whether inside its range or not.
std::vector<double> sellmeier_poles(const dispersion& law) {
    std::vector<double> poles;
    if (law.formula != 1 && law.formula != 2) return poles;
    const std::vector<double>& c = law.coefficients;
    for (std::size_t j = 1; j + 1 < c.size(); j += 2)
        if (c[j] != 0 && c[j + 1] > 0)
            poles.push_back(1000 * (law.formula == 1 ? c[j + 1] : std::sqrt(c[j + 1])));
    return poles;
}

/// The first wavelength at which a formula gives no real n: looked for beside each pole and at 400 places,
/// evenly spread in the logarithm.
std::optional<double> first_pole(const dispersion& law) {
    std::vector<double> places;
    for (const double pole : sellmeier_poles(law))
        for (const double step : {-1e-3, -1e-6, 0.0, 1e-6, 1e-3})
            places.push_back(pole * (1 + step));
    for (int i = 0; i <= 400; ++i)
        places.push_back(law.lo_nm * std::pow(law.hi_nm / law.lo_nm, i / 400.0));
    std::ranges::sort(places);
    for (const double nm : places)
        if (nm >= law.lo_nm && nm <= law.hi_nm && std::isnan(value_at(law, nm))) return nm;
    return {};
}

void note_pole(const dispersion& law, std::vector<std::string>& diagnostics) {
    if (const auto nm = first_pole(law))
        diagnostics.push_back(fmt::format("n: formula has a pole near {:.6g} nm", *nm));
}

void note_odd_one(const dispersion& law, std::vector<std::string>& diagnostics) {
    const bool in_pairs = law.formula <= 6 && law.formula != 4;
    if (in_pairs && law.coefficients.size() % 2 == 0)
        diagnostics.push_back("n: last coefficient has no partner, which counts as 0");
}

// ---- the page -------------------------------------------------------------------------------------------------

void set_once(std::optional<spectrum>& slot, spectrum value, std::string_view what,
              std::vector<std::string>& diagnostics) {
    if (slot)
        diagnostics.push_back(fmt::format("{}: given twice, the first counts", what));
    else
        slot = std::move(value);
}

void add_samples(page& result, std::optional<spectrum>& slot, samples rows, std::string_view what) {
    note_negative(rows, what, result.diagnostics);
    set_once(slot, sorted_samples(std::move(rows), what, result.diagnostics), what, result.diagnostics);
}

void add_table(page& result, const page_block& block, const std::string& file) {
    const std::string_view what = std::string_view(block.type).substr(10);
    const bool has_n = what != "k", has_k = what != "n";
    columns table = read_table(block, has_n, has_k, file);
    if (has_n) add_samples(result, result.n, std::move(table.n), "n");
    if (has_k) add_samples(result, result.k, std::move(table.k), "k");
}

void add_formula(page& result, const page_block& block, const std::string& file) {
    const dispersion law = read_formula(block, file);
    note_odd_one(law, result.diagnostics);
    note_pole(law, result.diagnostics);
    set_once(result.n, law, "n", result.diagnostics);
}

void add(page& result, const page_block& block, const std::string& file) {
    const std::string& t = block.type;
    if (t == "tabulated nk" || t == "tabulated n" || t == "tabulated k")
        add_table(result, block, file);
    else if (t.size() == 9 && t.starts_with("formula ") && t[8] >= '1' && t[8] <= '9')
        add_formula(result, block, file);
    else
        fail(file, block.line,
             fmt::format("type '{:.40}' is unknown; tabulated nk, n, k and formula 1 to 9 are known", t));
}

/// The first DOI of a text with links: up to a quote, a tag, white space or an unopened bracket.
std::string first_doi(std::string_view text) {
    constexpr std::string_view host = "doi.org/";
    const std::size_t start = text.find(host);
    if (start == std::string_view::npos) return "";
    text.remove_prefix(start + host.size());
    std::size_t end = 0;
    for (int open = 0; end < text.size(); ++end) {
        open += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        if (open < 0 || std::string_view("\"'<> \t\r\n").find(text[end]) != std::string_view::npos) break;
    }
    return std::string(text.substr(0, end));
}

bool read_fields(events& yaml, page& result) {
    bool has_data = false;
    for_each_entry(yaml, "a page", [&](const std::string& key) {
        if (key == "REFERENCES") {
            const std::string text = text_value(yaml, key);
            result.references = plain_text(text), result.doi = first_doi(text);
        } else if (key == "COMMENTS") {
            result.comments = plain_text(text_value(yaml, key));
        } else if (key == "CONDITIONS") {
            result.conditions = read_texts(yaml, key);
        } else if (key == "PROPERTIES") {
            result.properties = read_texts(yaml, key);
        } else if (key == "DATA") {
            result.blocks = read_blocks(yaml), has_data = true;
        } else {
            skip(yaml);
        }
    });
    return has_data;
}

// ---- plain text -----------------------------------------------------------------------------------------------

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t i = 0; (i = text.find(from, i)) != std::string::npos; i += to.size())
        text.replace(i, from.size(), to);
}

/// Without <tags>; a < that begins no tag stays. A line break becomes a space.
std::string without_tags(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool tag = text[i] == '<' && i + 1 < text.size() &&
                         (std::isalpha(static_cast<unsigned char>(text[i + 1])) || text[i + 1] == '/');
        const std::size_t end = tag ? text.find('>', i) : std::string_view::npos;
        if (end == std::string_view::npos) {
            result += text[i];
            continue;
        }
        if (text.substr(i, 3) == "<br" || text.substr(i, 2) == "<p" || text.substr(i, 4) == "</p>")
            result += ' ';
        i = end;
    }
    return result;
}

/// [text](address) to text.
std::string without_links(std::string text) {
    for (std::size_t i = 0; (i = text.find("](", i)) != std::string::npos;) {
        const std::size_t open = text.rfind('[', i), close = text.find(')', i);
        if (open == std::string::npos || close == std::string::npos) {
            i += 2;
            continue;
        }
        text.erase(i, close + 1 - i), text.erase(open, 1);
    }
    return text;
}

/// **text** and *text* to text, where the marks touch it; a lone star is a footnote or a product and stays.
std::string without_emphasis(std::string text, std::string_view mark) {
    const std::size_t m = mark.size();
    for (std::size_t i = 0; (i = text.find(mark, i)) != std::string::npos;) {
        const std::size_t end = text.find(mark, i + m);
        if (end == std::string::npos) break;
        const bool touches = end > i + m && text[i + m] != ' ' && text[end - 1] != ' ';
        if (touches) text.erase(end, m), text.erase(i, m);
        i = touches ? end - m : i + m;
    }
    return text;
}

std::string on_one_line(std::string_view text) {
    std::string result;
    for (const std::string_view word : words(text)) {
        if (!result.empty()) result += ' ';
        result += word;
    }
    return result;
}

/// A decimal without exponent, times ten to the `places`, digit for digit.
std::string shifted(std::string_view decimal, int places) {
    const std::size_t point = std::min(decimal.find('.'), decimal.size());
    std::string digits(decimal.substr(0, point));
    auto before = static_cast<int>(digits.size()) + places; // how many digits stand before the point
    digits += decimal.substr(std::min(point + 1, decimal.size()));
    if (before < 1) digits.insert(0, static_cast<std::size_t>(1 - before), '0'), before = 1;
    const auto whole = static_cast<std::size_t>(before);
    if (digits.size() < whole) digits.append(whole - digits.size(), '0');
    const std::size_t zeros = std::min(digits.find_first_not_of('0'), whole - 1);
    const std::string fraction = digits.substr(whole);
    return digits.substr(zeros, whole - zeros) + (fraction.empty() ? "" : "." + fraction);
}

} // namespace

std::string plain_text(std::string_view marked) {
    std::string text = without_links(without_tags(marked));
    for (const std::string_view mark : {"**", "*", "`"})
        text = without_emphasis(std::move(text), mark);
    constexpr std::pair<std::string_view, std::string_view> entities[] = {
        {"&nbsp;", " "},  {"&lt;", "<"},    {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"},
        {"&ndash;", "–"}, {"&mdash;", "—"}, {"&mu;", "µ"}, {"&deg;", "°"},   {"&amp;", "&"}};
    for (const auto& [entity, character] : entities)
        replace_all(text, entity, character);
    return on_one_line(text);
}

std::string nanometres(std::string_view micrometres) {
    const std::size_t e = std::min(micrometres.find_first_of("eE"), micrometres.size());
    const double power = e < micrometres.size() ? parse_number(micrometres.substr(e + 1)).value_or(0) : 0;
    const std::string_view mantissa = micrometres.substr(0, e);
    if (std::abs(power) > 30) return fmt::format("{}e{}", mantissa, power + 3);
    return shifted(mantissa, static_cast<int>(power) + 3);
}

page read_page(std::string_view text, const std::string& file) {
    if (trimmed(text).empty()) fail(file, 1, "is empty; a page has REFERENCES and DATA");
    events yaml(text, file);
    yaml.next(); // stream
    if (yaml.next() != YAML_DOCUMENT_START_EVENT) yaml.stop("has no content; a page has REFERENCES and DATA");
    yaml.next();
    page result;
    if (!read_fields(yaml, result) || result.blocks.empty())
        fail(file, line_at(text, text.size()), "has no DATA");
    for (const page_block& block : result.blocks)
        add(result, block, file);
    return result;
}

page read_page_file(const std::string& path) { return read_page(read_text_file(path), path); }

material material_of(const page& source, const std::string& path) {
    if (!source.n) throw bad_input(fmt::format("{}: gives k only; reflectance needs n as well", path));
    material what;
    const std::filesystem::path file(path);
    const std::string generic = file.generic_string();
    const std::size_t data = generic.rfind("/data/");
    what.name = file.stem().string();
    what.page = generic.substr(data == std::string::npos ? 0 : data + 6);
    if (what.page.ends_with(".yml")) what.page.resize(what.page.size() - 4);
    what.n = source.n, what.k = source.k;
    what.range_nm = known_range(what);
    what.category = guessed_class(what);
    what.citation = source.references, what.doi = source.doi, what.licence = "not stated";
    what.quality = source.comments;
    for (const std::string& remark : source.diagnostics)
        what.quality += (what.quality.empty() ? "" : "; ") + remark;
    return what;
}

} // namespace fresnel
