#include "analysis/plot.hpp"

#include "analysis/drawing.hpp"
#include "analysis/fit.hpp"
#include "analysis/identify.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel {

namespace {

constexpr double step_deg = 0.25;

// Channels that differ by less are one line in a figure: the dispersion of an ordinary glass.
constexpr double line_width = 0.01;

// As many entries of a family as a legend holds beside a panel.
constexpr std::size_t most_labels = 10, most_curves = 64;

using channel_values = std::array<parameters, 3>;
using family_value = std::optional<double>;

bool is_exact(const plot_subject& s) { return s.substance || s.model->polarised(); }

bool takes(const plot_subject& s, std::string_view parameter_name) {
    if (s.model == nullptr) return false;
    const auto& all = s.model->parameters;
    return std::any_of(all.begin(), all.end(), [&](const parameter& p) { return p.name == parameter_name; });
}

// Subjects and reference.
std::vector<const plot_subject*> everything(const plot_request& asked) {
    std::vector<const plot_subject*> all;
    if (asked.reference) all.push_back(&*asked.reference);
    for (const plot_subject& s : asked.subjects)
        all.push_back(&s);
    return all;
}

// ---- what does not go together ------------------------------------------------------------------------------

void check_parameter(const plot_request& asked, const std::string& name, double value) {
    std::vector<std::string> known;
    bool taken = false;
    for (const plot_subject* s : everything(asked)) {
        if (s->model == nullptr) continue;
        for (const parameter& p : s->model->parameters) {
            known.emplace_back(p.name);
            if (p.name == name) check_range(p, value), taken = true;
        }
    }
    if (!taken)
        throw bad_input(fmt::format("{} = {}: is a parameter of none of the models, which take {}", name,
                                    value,
                                    known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
}

void check_family(const plot_request& asked) {
    const plot_family& family = *asked.family;
    if (family.values.size() > most_curves)
        throw bad_input(fmt::format("--family {}: has {} values, must have at most {}", family.parameter,
                                    family.values.size(), most_curves));
    if (asked.given.contains(family.parameter))
        throw bad_input(fmt::format("--family {}: the parameter is given on its own as well; give it once",
                                    family.parameter));
    for (const double value : family.values)
        check_parameter(asked, family.parameter, value);
}

void check_polarizations(const plot_request& asked) {
    const auto is_mean = [](polarization p) { return p == polarization::mean; };
    if (std::all_of(asked.polarizations.begin(), asked.polarizations.end(), is_mean)) return;
    for (const plot_subject* s : everything(asked))
        if (!is_exact(*s))
            throw bad_input(
                fmt::format("--polarization: {} has no s and p; plot exact models and materials, or "
                            "r alone",
                            s->name));
}

void check_reference(const plot_request& asked) {
    if (!is_exact(*asked.reference))
        throw bad_input(fmt::format("--error '{}': is an approximation; must be a material or an exact model",
                                    asked.reference->name));
    if (asked.subjects.empty())
        throw bad_input(fmt::format("--error '{}': leaves nothing to compare with it; name a model too",
                                    asked.reference->name));
}

void check_surface(const plot_request& asked) {
    if (asked.subjects.size() != 1 || !asked.subjects[0].substance || asked.reference)
        throw bad_input("--surface: takes one material and nothing else");
    if (asked.family || asked.wavelength_nm || asked.strips || asked.fitted_to ||
        asked.against != abscissa::theta || asked.polarizations.size() != 1)
        throw bad_input("--surface: goes with --ambient and one --polarization only");
}

void check(const plot_request& asked) {
    for (const auto& [name, value] : asked.given)
        check_parameter(asked, name, value);
    if (asked.family) check_family(asked);
    check_polarizations(asked);
    if (asked.reference) check_reference(asked);
    if (asked.surface) check_surface(asked);
    const auto is_model = [](const plot_subject& s) { return s.model != nullptr; };
    if (asked.fitted_to && std::none_of(asked.subjects.begin(), asked.subjects.end(), is_model))
        throw bad_input(fmt::format("--fit '{}': there is no model to fit; name one", asked.fitted_to->name));
}

// ---- curves -------------------------------------------------------------------------------------------------

/// A curve before it has a colour, the same in all channels for what has none.
struct curve {
    const plot_subject* subject;
    family_value value; ///< of the family's parameter, where the curve depends on it
    polarization which;
    std::vector<rgb> R;
    std::string_view end = ""; ///< of a range: " low end" or " high end"
};

bool is_grey(const rgb& v) { return v[0] == v[1] && v[1] == v[2]; }

/// Evaluates subjects over the angles.
class evaluator {
public:
    explicit evaluator(const plot_request& asked) : asked_(asked) {
        const int steps = static_cast<int>(std::lround(90 / step_deg));
        for (int i = 0; i <= steps; ++i) {
            theta_deg.push_back(90.0 * i / steps);
            cos_i.push_back(cosine_of_degrees(theta_deg.back()));
        }
    }

    std::vector<rgb> reflectance(const plot_subject& s, family_value value, polarization which) const {
        if (s.substance) return of_material(*s.substance, which);
        const channel_values parameters = values_of(s, value);
        const rgb white = white_for(s);
        std::vector<rgb> R;
        for (const double c : cos_i)
            R.push_back(of_model(*s.model, parameters, c, which, white));
        return R;
    }

    /// Whether a curve changes with the family's parameter, its own or that of what it is fitted to.
    bool varies(const plot_subject& s) const {
        if (!asked_.family || s.model == nullptr) return false;
        const plot_subject* target = target_of(s);
        return takes(s, asked_.family->parameter) || (target != nullptr && varies(*target));
    }

    /// What a model is fitted to; nothing for a material and for a model that stands on its own.
    const plot_subject* target_of(const plot_subject& s) const {
        if (s.model == nullptr) return nullptr;
        if (fitted_to_) return &*fitted_to_;
        for (const auto& [name, ignored] : asked_.given)
            if (takes(s, name)) return nullptr;
        const auto suits = [&](const plot_subject& t) {
            return t.substance || (!is_exact(s) && is_exact(t) && &t != &s);
        };
        if (asked_.reference && suits(*asked_.reference)) return &*asked_.reference;
        for (const plot_subject& t : asked_.subjects)
            if (t.substance) return &t;
        for (const plot_subject& t : asked_.subjects)
            if (suits(t)) return &t;
        return nullptr;
    }

    /// The parameters of a model in each channel.
    channel_values values_of(const plot_subject& s, family_value value) const {
        channel_values all = start(s, value);
        for (parameters& values : all)
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::string name(s.model->parameters[i].name);
                const auto found = asked_.given.find(name);
                if (found != asked_.given.end()) values[i] = found->second;
                if (value && name == asked_.family->parameter) values[i] = *value;
            }
        return all;
    }

    std::vector<double> theta_deg, cos_i;

private:
    std::vector<rgb> of_material(const material& m, polarization which) const {
        if (!asked_.wavelength_nm) return exact_curve(m, asked_.space, asked_.ambient, step_deg, which).value;
        std::vector<rgb> R;
        for (const auto& at_angle :
             exact_surface(m, asked_.ambient, {*asked_.wavelength_nm}, theta_deg, which).R)
            R.push_back({at_angle[0], at_angle[0], at_angle[0]});
        return R;
    }

    // The colour that stands for R = 1: of the space for a material's colours and for models that are fitted to or
    // compared with them; else 1, a reflectance without colour.
    rgb white_for(const plot_subject& s) const {
        if (asked_.wavelength_nm) return {1, 1, 1};
        const plot_subject* target = target_of(s);
        if (s.substance || (target == nullptr && asked_.reference && asked_.reference->substance))
            return white_of(asked_.space);
        return target == nullptr ? rgb{1, 1, 1} : white_for(*target);
    }

    static rgb of_model(const model_row<double>& model, const channel_values& values, double c,
                        polarization which, const rgb& white) {
        rgb R{};
        for (std::size_t i = 0; i < 3; ++i)
            R[i] = i > 0 && values[i] == values[0]
                       ? R[0]
                       : reflectance_of(model.evaluate(values[i].data(), c), which);
        return {white[0] * R[0], white[1] * R[1], white[2] * R[2]};
    }

    rgb at_cosine(const plot_subject& s, family_value value, double c) const {
        if (s.model != nullptr)
            return of_model(*s.model, values_of(s, value), c, polarization::mean, white_for(s));
        if (!asked_.wavelength_nm) return colour_at(*s.substance, asked_.space, asked_.ambient, c);
        const optical_index index = index_at(*s.substance, *asked_.wavelength_nm);
        const double R = conductor(asked_.ambient, index.n, index.k, c).reflectance();
        return {R, R, R};
    }

    double ambient_of(const plot_subject& s, family_value value) const {
        return takes(s, "n_i") ? values_of(s, value)[0][0] : asked_.ambient;
    }

    // Fitted values, or defaults.
    channel_values start(const plot_subject& s, family_value value) const {
        if (const plot_subject* target = target_of(s)) return fitted(s.model->name, *target, value);
        parameters values;
        for (const parameter& p : s.model->parameters)
            values.push_back(p.name == "n_i" ? asked_.ambient : p.default_value);
        return {values, values, values};
    }

    channel_values fitted(std::string_view model, const plot_subject& target, family_value value) const {
        const rgb_curve exact{asked_.space, theta_deg, cos_i, reflectance(target, value, polarization::mean)};
        const rgb f0 = at_cosine(target, value, 1), f82 = at_cosine(target, value, ratio<double, 1, 7>());
        const bool grey_target = std::all_of(exact.value.begin(), exact.value.end(), is_grey);
        channel_values values;
        for (std::size_t i = 0; i < 3; ++i)
            values[i] =
                i > 0 && grey_target
                    ? values[0]
                    : fit(model, channel_of(exact, f0, f82, ambient_of(target, value), i, white_for(target)));
        return values;
    }

    const plot_request& asked_;
    std::optional<plot_subject> fitted_to_ =
        asked_.fitted_to ? std::optional(plot_subject{asked_.fitted_to->name, nullptr, asked_.fitted_to})
                         : std::nullopt;
};

std::vector<family_value> values_of_family(const plot_request& asked, bool varies) {
    if (!varies) return {std::nullopt};
    return {asked.family->values.begin(), asked.family->values.end()};
}

// The curves of a subject: one for each polarization and value of the family, and the ends of a range.
std::vector<curve> curves_of(const plot_subject& s, const plot_request& asked, const evaluator& with) {
    std::vector<curve> curves;
    // an error varies with its reference
    const bool varies = with.varies(s) || (asked.reference && with.varies(*asked.reference));
    for (const polarization which : asked.polarizations) {
        for (const family_value value : values_of_family(asked, varies))
            curves.push_back({&s, value, which, with.reflectance(s, value, which)});
        if (varies || !s.substance || !has_range(*s.substance)) continue;
        const auto add_end = [&](const material& end, std::string_view name) {
            curves.push_back({&s, {}, which, with.reflectance({s.name, nullptr, end}, {}, which), name});
        };
        add_end(low_end(*s.substance), " low end"), add_end(high_end(*s.substance), " high end");
    }
    return curves;
}

// Whether any curve of the subject shows its channels apart.
bool is_coloured(const std::vector<curve>& curves, color_space space) {
    const double allowed = space == color_space::xyz ? 0 : line_width;
    for (const curve& c : curves)
        for (const rgb& v : c.R)
            if (std::max({v[0], v[1], v[2]}) - std::min({v[0], v[1], v[2]}) > allowed) return true;
    return false;
}

void to_luminance(curve& c, color_space space) {
    const recipe& how = default_recipe(space);
    for (rgb& v : c.R)
        if (!is_grey(v)) v.fill((how.to_xyz * v)[1]);
}

void subtract(std::vector<rgb>& from, const std::vector<rgb>& what) {
    for (std::size_t a = 0; a < from.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
            from[a][i] -= what[a][i];
}

/// The curves of one subject, ready to be drawn.
struct curve_group {
    const plot_subject* subject;
    bool coloured; ///< three channels; otherwise all are the same
    std::vector<curve> curves;
    std::vector<std::vector<rgb>> colors; ///< of each curve before a reference was taken from it
};

curve_group group_of(const plot_subject& s, const plot_request& asked, const evaluator& with) {
    curve_group group{&s, false, curves_of(s, asked, with), {}};
    std::vector<curve> references;
    if (asked.reference)
        for (const curve& c : group.curves)
            references.push_back(
                {&*asked.reference, c.value, c.which, with.reflectance(*asked.reference, c.value, c.which)});
    group.coloured = is_coloured(group.curves, asked.space) || is_coloured(references, asked.space);
    for (std::size_t i = 0; i < group.curves.size(); ++i) {
        group.colors.push_back(group.curves[i].R);
        if (!group.coloured) to_luminance(group.curves[i], asked.space);
        if (references.empty()) continue;
        if (!group.coloured) to_luminance(references[i], asked.space);
        subtract(group.curves[i].R, references[i].R);
    }
    return group;
}

// ---- names and looks ----------------------------------------------------------------------------------------

// As much of a name as a legend holds, together with `suffix`.
std::string legend_name(const std::string& name, const std::string& suffix = "") {
    const std::size_t most = 20 - std::min<std::size_t>(suffix.size(), 14);
    const std::string file = name.substr(name.rfind('/') + 1);
    return (file.size() <= most ? file : file.substr(0, most - 1) + "…") + suffix;
}

std::string list_of(const std::vector<plot_subject>& subjects) {
    const auto name = [&](std::size_t i) { return legend_name(subjects[i].name); };
    switch (subjects.size()) {
    case 1:
        return name(0);
    case 2:
        return name(0) + " and " + name(1);
    case 3:
        return name(0) + ", " + name(1) + " and " + name(2);
    default:
        return fmt::format("{}, {} and {} others", name(0), name(1), subjects.size() - 2);
    }
}

std::string polarization_suffix(const curve& c, const plot_request& asked) {
    if (asked.polarizations.size() == 1) return "";
    return c.which == polarization::s ? " s" : c.which == polarization::p ? " p" : " mean";
}

std::string full_name(const curve& c, const plot_request& asked) {
    return c.subject->name + std::string(c.end) + polarization_suffix(c, asked) +
           (c.value ? fmt::format(" {} = {:.6g}", asked.family->parameter, *c.value) : "");
}

/// Places of a group among those that are drawn alike.
struct place {
    std::size_t index; ///< among all
    std::size_t exact; ///< among those that are exact
    std::size_t rank;  ///< 0 for what is exact; approximations are counted from 1, or from 0 where nothing is
    std::size_t varying; ///< among those that the family changes
    bool alone = true;   ///< the only one of these
};

std::vector<place> places_of(const std::vector<curve_group>& groups) {
    const bool any_exact =
        std::any_of(groups.begin(), groups.end(), [](const curve_group& g) { return is_exact(*g.subject); });
    std::vector<place> places;
    std::size_t exact = 0, rank = any_exact ? 1 : 0, varying = 0;
    for (const curve_group& g : groups) {
        places.push_back({places.size(), exact, is_exact(*g.subject) ? 0 : rank, varying});
        ++(is_exact(*g.subject) ? exact : rank);
        if (g.curves.front().value) ++varying;
    }
    for (place& p : places)
        p.alone = varying == 1;
    return places;
}

// Solid, then dashed and dotted in turn.
stroke stroke_of(std::size_t i) {
    return i == 0 ? stroke::solid : i % 2 == 1 ? stroke::dashed : stroke::dotted;
}

stroke style_of(const curve& c, const place& at, const plot_request& asked) {
    if (asked.polarizations.size() == 1) return stroke_of(at.rank);
    return c.which == polarization::mean ? stroke::solid
           : c.which == polarization::s  ? stroke::dashed
                                         : stroke::dotted;
}

// Lighter and darker in turn.
double shade_of(std::size_t i) { return i == 0 ? 0 : i % 2 == 1 ? -0.45 : 0.45; }

std::string color_of(const curve& c, std::size_t channel, bool coloured, const place& at,
                     const plot_request& asked) {
    if (asked.family && !c.value) return "#808080";
    if (c.value) {
        const std::vector<double>& all = asked.family->values;
        const auto i = static_cast<double>(std::find(all.begin(), all.end(), *c.value) - all.begin());
        return viridis(0.9 * i /
                       std::max(1.0, static_cast<double>(all.size() - 1))); // its yellow end is too pale
    }
    if (coloured)
        return shaded(channel_colors[channel], shade_of(at.rank == 0 ? at.exact : (at.rank - 1) / 2));
    return shaded(model_colors[at.index % model_colors.size()], shade_of(at.index / model_colors.size()));
}

bool has_legend_entry(const curve& c, const place& at, const plot_request& asked) {
    if (!c.value) return true;
    const std::vector<double>& all = asked.family->values;
    const auto i = static_cast<std::size_t>(std::find(all.begin(), all.end(), *c.value) - all.begin());
    if (at.varying > 0) return i + 1 == all.size();
    const std::size_t every = (all.size() + most_labels - 1) / most_labels;
    return i % every == 0;
}

std::string legend_entry(const curve& c, const place& at, const plot_request& asked) {
    if (!c.end.empty() || !has_legend_entry(c, at, asked)) return "";
    const std::string suffix = polarization_suffix(c, asked);
    if (!c.value || at.varying > 0) return legend_name(c.subject->name, suffix);
    const std::string value = fmt::format("{} = {:.4g}{}", asked.family->parameter, *c.value, suffix);
    return at.alone || *c.value != asked.family->values.front() ? value
                                                                : legend_name(c.subject->name, " " + value);
}

// ---- the figure ---------------------------------------------------------------------------------------------

axis x_axis_of(abscissa against) {
    switch (against) {
    case abscissa::cos_theta:
        return {"cos θ", 0, 1, 0.2};
    case abscissa::sin_theta:
        return {"sin θ", 0, 1, 0.2};
    default:
        return theta_axis;
    }
}

// The x of an angle, and the angle of an x.
double x_of(double theta_deg, abscissa against) {
    return against == abscissa::theta       ? theta_deg
           : against == abscissa::cos_theta ? cosine_of_degrees(theta_deg)
                                            : cosine_of_degrees(90 - theta_deg);
}

double theta_of(double x, abscissa against) {
    return against == abscissa::theta       ? x
           : against == abscissa::cos_theta ? degrees_of_cosine(x)
                                            : 90 - degrees_of_cosine(x);
}

/// Turns groups of curves into panels.
class drawing {
public:
    drawing(const plot_request& asked, const evaluator& with, const std::vector<curve_group>& groups)
        : asked_(asked), groups_(groups), places_(places_of(groups)) {
        for (const double theta : with.theta_deg)
            x_.push_back(x_of(theta, asked.against));
    }

    std::vector<panel> panels() {
        const bool coloured =
            std::any_of(groups_.begin(), groups_.end(), [](const curve_group& g) { return g.coloured; });
        if (!asked_.family || !coloured) return {panel_of({0, 1, 2}, coloured)};
        std::vector<panel> all; // the family has taken the colours
        for (std::size_t c = 0; c < 3; ++c)
            all.push_back(panel_of({c}, true));
        return all;
    }

private:
    panel panel_of(const std::vector<std::size_t>& channels, bool coloured) {
        panel p{x_axis_of(asked_.against), {}, {}, {}};
        for (std::size_t g = 0; g < groups_.size(); ++g)
            for (const curve& c : groups_[g].curves)
                for (const std::size_t channel : channels)
                    if (groups_[g].coloured || channel == channels.front())
                        p.curves.push_back(series_of(c, groups_[g].coloured, channel, places_[g]));
        label_channels(p, coloured && channels.size() == 3);
        const std::string label = y_label(coloured ? channels : std::vector<std::size_t>{});
        p.y = asked_.reference ? error_axis(label, p.curves) : reflectance_axis(label, p.curves);
        return p;
    }

    series series_of(const curve& c, bool coloured, std::size_t channel, const place& at) {
        series s = channel_series(c.R, x_, channel);
        s.color = color_of(c, channel, coloured, at, asked_);
        s.style = style_of(c, at, asked_);
        s.width = !c.end.empty() ? 1 : s.style == stroke::solid ? 2.2 : 1.8;
        if (!coloured || channel == 0 || asked_.family) s.label = legend_entry(c, at, asked_);
        s.name = full_name(c, asked_) +
                 (coloured ? fmt::format(" {}", channel_letters(asked_.space)[channel]) : "");
        return s;
    }

    // The first curve says which colour is which channel.
    void label_channels(panel& p, bool three) const {
        if (!three) return;
        const auto first =
            std::find_if(groups_.begin(), groups_.end(), [](const curve_group& g) { return g.coloured; });
        std::size_t at = 0;
        for (auto g = groups_.begin(); g != first; ++g)
            at += g->curves.size();
        const curve& c = first->curves.front();
        for (std::size_t i = 0; i < 3; ++i)
            p.curves[at + i].label =
                legend_name(c.subject->name, fmt::format("{} {}", polarization_suffix(c, asked_),
                                                         channel_letters(asked_.space)[i]));
    }

    bool has_material() const {
        const auto all = everything(asked_);
        return asked_.fitted_to || std::any_of(all.begin(), all.end(), [](const plot_subject* s) {
                   return s->substance.has_value();
               });
    }

    std::string y_label(const std::vector<std::size_t>& channels) const {
        std::string label = asked_.reference ? "error: model − " + legend_name(asked_.reference->name)
                            : asked_.polarizations.size() > 1            ? "reflectance"
                            : asked_.polarizations[0] == polarization::s ? "reflectance R s"
                            : asked_.polarizations[0] == polarization::p ? "reflectance R p"
                                                                         : "reflectance";
        if (asked_.wavelength_nm && has_material()) label += fmt::format(", {} nm", *asked_.wavelength_nm);
        if (channels.empty()) return label;
        return fmt::format(
            "{} ({}{})", label, space_title(asked_.space),
            channels.size() == 1 ? fmt::format(", {}", channel_letters(asked_.space)[channels[0]]) : "");
    }

    const plot_request& asked_;
    const std::vector<curve_group>& groups_;
    std::vector<place> places_;
    std::vector<double> x_;
};

// The curve at places that are even in x, which a strip needs.
std::vector<rgb> resampled(const std::vector<rgb>& R, abscissa against) {
    constexpr int pixels = 181;
    const axis x = x_axis_of(against);
    std::vector<rgb> result;
    for (int i = 0; i < pixels; ++i) {
        const double theta = theta_of(x.lo + (x.hi - x.lo) * i / (pixels - 1), against);
        const double at = std::clamp(theta / step_deg, 0.0, static_cast<double>(R.size() - 1));
        const auto a = std::min(static_cast<std::size_t>(at), R.size() - 2);
        rgb& color = result.emplace_back();
        for (std::size_t c = 0; c < 3; ++c)
            color[c] = mix(R[a][c], R[a + 1][c], at - static_cast<double>(a));
    }
    return result;
}

strip strip_of(const std::string& name, std::vector<rgb> R, const plot_request& asked) {
    for (rgb& v : R)
        if (is_grey(v)) v = grey(v[0], asked.space);
    return color_strip(name, resampled(R, asked.against), asked.space, 1);
}

strips strips_of(const std::vector<curve_group>& groups, const plot_request& asked, const evaluator& with) {
    strips all{x_axis_of(asked.against), {}};
    if (asked.reference && !with.varies(*asked.reference))
        all.rows.push_back(strip_of(legend_name(asked.reference->name),
                                    with.reflectance(*asked.reference, {}, asked.polarizations[0]), asked));
    for (const curve_group& g : groups)
        for (std::size_t i = 0; i < g.curves.size(); ++i) {
            const curve& c = g.curves[i];
            if (!c.end.empty()) continue;
            const std::string name =
                c.value ? fmt::format("{} {:.4g}", g.subject->name, *c.value) : g.subject->name;
            all.rows.push_back(
                strip_of(legend_name(name, polarization_suffix(c, asked)), g.colors[i], asked));
        }
    return all;
}

std::string title_of(const plot_request& asked) {
    if (!asked.title.empty()) return asked.title;
    const std::string names = list_of(asked.subjects);
    if (asked.surface) return names + ": reflectance over wavelength and angle";
    std::string title = asked.reference
                            ? fmt::format("{}: error against {}", names, legend_name(asked.reference->name))
                            : names + ": reflectance";
    if (asked.family)
        title += fmt::format(", {} from {:.4g} to {:.4g}", asked.family->parameter,
                             asked.family->values.front(), asked.family->values.back());
    return title;
}

std::string parameter_text(const channel_values& values, std::size_t i) {
    const double r = values[0][i], g = values[1][i], b = values[2][i];
    return r == g && g == b ? fmt::format("{:.5g}", r) : fmt::format("{:.5g} {:.5g} {:.5g}", r, g, b);
}

// "schlick (fitted to copper): f0 = 0.9 0.7 0.5."
std::string parameters_of(const plot_subject& s, const evaluator& with) {
    if (s.model == nullptr || s.model->parameters.empty() || with.varies(s)) return "";
    const channel_values values = with.values_of(s, {});
    const plot_subject* target = with.target_of(s);
    std::string text = s.name + (target != nullptr ? fmt::format(" (fitted to {})", target->name) : "") + ":";
    for (std::size_t i = 0; i < s.model->parameters.size(); ++i)
        text += fmt::format("{} {} = {}", i == 0 ? "" : ",", s.model->parameters[i].name,
                            parameter_text(values, i));
    return text + ". ";
}

std::string caption_of(const plot_request& asked, const evaluator& with) {
    std::string text;
    for (const plot_subject* s : everything(asked))
        text += parameters_of(*s, with);
    text += asked.wavelength_nm ? fmt::format("At {} nm", *asked.wavelength_nm) : recipe_text(asked.space);
    return text + fmt::format(", ambient {}.", asked.ambient);
}

} // namespace

plot_subject find_subject(const std::string& name) {
    std::vector<std::string> names;
    for (const model_row<double>& row : model_table<double>()) {
        if (row.name == name) return {name, &row, {}};
        names.emplace_back(row.name);
    }
    if (find_material(name) != nullptr || name.ends_with(".yml") || name.ends_with(".csv")) {
        material substance = load_material(name);
        return {substance.name, nullptr, substance};
    }
    for (const material& m : builtin_materials())
        names.push_back(m.name);
    throw bad_input(fmt::format("'{:.80}' is neither a model nor a material{}; `fresnel models` and `fresnel "
                                "materials` list them",
                                name, did_you_mean(name, names)));
}

figure make_plot(const plot_request& asked) {
    check(asked);
    const evaluator with(asked);
    figure result;
    result.id = asked.id, result.title = title_of(asked), result.caption = caption_of(asked, with);
    if (asked.surface) {
        result.surface =
            spectral_height_field(*asked.subjects[0].substance, asked.ambient, asked.polarizations[0]);
        return result;
    }
    std::vector<curve_group> groups;
    for (const plot_subject& s : asked.subjects)
        groups.push_back(group_of(s, asked, with));
    result.panels = drawing(asked, with, groups).panels();
    if (asked.strips) result.colors = strips_of(groups, asked, with);
    return result;
}

} // namespace fresnel
