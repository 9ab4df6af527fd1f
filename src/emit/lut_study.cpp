#include "emit/lut_study.hpp"

#include "analysis/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel::emit {

namespace {

constexpr std::array textures = {texel_format::r8, texel_format::r16, texel_format::r16f,
                                 texel_format::rgba32f};

bool begins_at_critical(const lut_map& map) { return map.name == "sqrt-cos"; }

// The subject as a map sees it: only sqrt-cos knows of the critical angle.
lut_subject seen_by(const lut_map& map, lut_subject subject) {
    if (!begins_at_critical(map)) subject.critical = 0;
    return subject;
}

// Errors of several tables of one subject and map, the reference made once.
class measure {
public:
    measure(const lut_map& map, const lut_subject& subject, std::size_t most)
        : map_(map), subject_(seen_by(map, subject)) {
        if (!subject_.by) reference_ = make_reference(subject_, most);
    }
    lut_error operator()(std::size_t size, texel_format format) const {
        const lut table = unmeasured(subject_, map_, {std::nullopt, size, size, format});
        return reference_ ? error_of(table, *reference_) : error_of(table);
    }

private:
    const lut_map& map_;
    lut_subject subject_;
    std::optional<lut_reference> reference_;
};

} // namespace

std::vector<std::size_t> studied_sizes(const lut_subject& subject) {
    if (subject.by) return {16, 32, 64};
    return {16, 32, 64, 256};
}

std::vector<lut_study_row> study_lut(const lut_subject& subject, const std::vector<std::size_t>& sizes) {
    std::vector<lut_study_row> rows;
    for (const lut_map& map : lut_maps()) {
        const measure errors(map, subject, *std::max_element(sizes.begin(), sizes.end()));
        for (const texel_format format : textures) {
            rows.push_back({&map, format, {}});
            for (const std::size_t size : sizes)
                rows.back().error.push_back(errors(size, format));
        }
    }
    return rows;
}

std::string study_text(const lut_subject& subject) {
    const std::vector<std::size_t> sizes = studied_sizes(subject);
    std::string text = fmt::format("{}: largest error\n{:<10}{:<9}", subject.caption, "map", "format");
    for (const std::size_t size : sizes)
        text += fmt::format("{:>10}", subject.by ? fmt::format("{0} x {0}", size) : std::to_string(size));
    for (const lut_study_row& row : study_lut(subject, sizes)) {
        text += fmt::format("\n{:<10}{:<9}", row.map->name, to_string(row.format));
        for (const lut_error& e : row.error)
            text += fmt::format("{:>10.2g}", e.max);
    }
    return text + "\n";
}

figure lut_figure(const lut_subject& subject, const std::string& id) {
    panel p{{"texels", 8, 1024, 2, true}, {"largest error", 1e-6, 1, 10, true}, {}, {}};
    std::size_t color = 0;
    for (const lut_map& map : lut_maps()) {
        const measure errors(map, subject, 1024);
        const bool cut = subject.critical > 0 && begins_at_critical(map);
        const std::string label = cut ? "√(cos θ − cos θ_c)" : std::string(map.even_in);
        series in_float{label, {}, {}, model_colors[color++]};
        series in_bytes{"", {}, {}, in_float.color, stroke::dashed, 1.4, label + ", r8"};
        for (std::size_t n = 8; n <= 1024; n *= 2) {
            in_float.x.push_back(static_cast<double>(n)), in_bytes.x.push_back(static_cast<double>(n));
            in_float.y.push_back(errors(n, texel_format::rgba32f).max);
            in_bytes.y.push_back(errors(n, texel_format::r8).max);
        }
        p.curves.push_back(in_float);
        if (map.offered) p.curves.push_back(in_bytes);
    }
    p.notes = {{1000, 1.1e-3, "8 bits", note::side::right}};
    return {
        id,
        fmt::format("Tables of {}", subject.caption),
        "Largest error of a table against its number of texels, for each way to place them; solid in 32-bit "
        "floats, dashed in 8 bits.",
        {p},
        {}};
}

} // namespace fresnel::emit
