#include "conform/binding.hpp"

#include "emit/printer.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fresnel::conform {

namespace {

/// Names under which functions in the wild take a quantity, without case and underscores, and what they are given.
struct alias {
    std::string_view expression, names; ///< names between spaces
};

constexpr std::array aliases = {
    alias{"cos_i",
          " cosi cos costheta costhetai cosine cosangle ci ct mu u c voh vdoth hdotv hov vh loh ldoth hdotl "
          "hol lh "
          "nov ndotv vdotn von nv nol ndotl ldotn lon nl dotnv dotvh dotnl dotlh ndoth costhetad x "},
    alias{"1 - cos_i", " oneminuscos oneminuscosi oneminuscostheta oneminusvoh oneminusndotv m "},
    alias{"f0", " f0 r0 fzero fnormal specularcolor speccolor specular reflectance basereflectivity color0 "
                "ks rf0 rnormal "},
    alias{"f90", " f90 r90 fgrazing specularf90 grazing color90 reflectance90 "},
    alias{"f82", " f82 color82 "},
    alias{"tint", " tint f82tint edgetint specularcolortint specularcolor82 "},
    alias{"n_i", " ni n1 etai ior1 iori iorin extior exteta etaext etaincident nin niin nambient "},
    alias{"n_t", " nt n2 etat ior2 iort iorout intior inteta etaint etatransmitted nout "},
    alias{"k_t", " kt k2 etak extinction absorption kappa "},
    alias{"eta", " eta ior etarel relativeior reletai relior iorratio refractiveindex index "},
    alias{"n", " n ior eta refractiveindex index iorn realior "},
    alias{"1 / eta", " inveta etainv invior etainverse rcpeta oneovereta "},
    alias{"k", " k extinction absorption kappa etak iork "},
    alias{"power", " power exponent exp p fresnelpower "},
    alias{"alpha", " alpha power exponent "},
    alias{"r", " r reflectivity f0 color basecolor specularcolor "},
    alias{"g", " g edgetint tint edgecolor edge "},
    alias{"bias", " bias fresnelbias "},
    alias{"scale", " scale fresnelscale "},
    alias{"a", " a "},
    alias{"normal", " normal n surfacenormal shadingnormal worldnormal h half halfvector halfdir hv wh "},
    alias{"direction", " direction v l view viewdir viewdirection viewvector eyedir eye e light lightdir "
                       "lightdirection wo wi "
                       "todirection tolight toeye h half halfvector halfdir hv wh "},
    alias{"-direction", " i incident incidentdir raydir raydirection rd d "},
};

std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name)
        if (c != '_') result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

std::size_t index_of(const model_row<double>& model, std::string_view parameter) {
    for (std::size_t i = 0; i < model.parameters.size(); ++i)
        if (model.parameters[i].name == parameter) return i;
    return model.parameters.size();
}

bool has(const model_row<double>& model, std::string_view parameter) {
    return index_of(model, parameter) < model.parameters.size();
}

// The parameters that a quantity is made of; empty where the model has no such quantity.
std::vector<std::string> made_of(const model_row<double>& model, const std::string& variable) {
    if (has(model, variable)) return {variable};
    if (variable == "eta" || variable == "n") {
        if (has(model, "n_t")) return {"n_t"};
        if (has(model, "n")) return {"n"};
        if (has(model, "f0")) return {"f0"};
    }
    if (variable == "k" && has(model, "k_t")) return {"k_t"};
    if (variable == "f0") {
        if (has(model, "r")) return {"r"};
        std::vector<std::string> all;
        for (const parameter& p : model.parameters)
            if (p.name != "n_i") all.emplace_back(p.name);
        return all;
    }
    return {};
}

bool is_vector(const std::string& variable) { return variable == "normal" || variable == "direction"; }

bool is_known(const model_row<double>& model, const std::string& variable) {
    return variable == "cos_i" || is_vector(variable) || !made_of(model, variable).empty();
}

std::vector<std::string> known_names(const model_row<double>& model) {
    std::vector<std::string> names;
    for (const parameter& p : model.parameters)
        names.emplace_back(p.name);
    for (const char* extra : {"eta", "n", "k", "f0"})
        if (!has(model, extra) && !made_of(model, extra).empty()) names.emplace_back(extra);
    for (const char* extra : {"cos_i", "normal", "direction"})
        names.emplace_back(extra);
    return names;
}

bool names_alike(const alias& each, std::string_view name) {
    return each.names.find(fmt::format(" {} ", plain(name))) != std::string_view::npos;
}

// Whether some argument is the angle; then no other is a direction.
bool takes_cosine(const signature& s) {
    for (const signature::argument& a : s.arguments)
        if (a.width == 1 && (names_alike(aliases[0], a.name) || names_alike(aliases[1], a.name))) return true;
    return false;
}

// What an argument of that name is given; empty where its name tells nothing, or only what others have already: a
// parameter of the model's, else the angle or a direction, else a quantity made of parameters.
std::string by_name(const model_row<double>& model, const signature& s, const signature::argument& a,
                    const std::vector<std::string>& taken) {
    const auto fits = [&](const alias& each, int round) {
        const std::string variable = expression_text("--args", each.expression).variables()[0];
        const bool vector = is_vector(variable), angle = variable == "cos_i";
        const int its_round = has(model, each.expression) ? 0 : vector || angle ? 1 : 2;
        if (its_round != round || !is_known(model, variable) || (vector && (a.width != 3 || takes_cosine(s))))
            return false;
        return names_alike(each, a.name) &&
               std::find(taken.begin(), taken.end(), each.expression) == taken.end();
    };
    for (const parameter& p : model.parameters)
        if (plain(p.name) == plain(a.name) && std::find(taken.begin(), taken.end(), p.name) == taken.end())
            return std::string(p.name);
    for (const int round : {0, 1, 2})
        for (const alias& each : aliases)
            if (fits(each, round)) return std::string(each.expression);
    return {};
}

} // namespace

binding::binding(const conform_request& wanted) : model_(&find_model<double>(wanted.model)) {
    const std::vector<signature> all = find_functions(wanted.language, wanted.text, wanted.function);
    if (all.empty()) {
        const std::vector<std::string> names = function_names(wanted.language, wanted.text);
        throw bad_input(fmt::format("--function '{}': {} defines no such function{}; it defines {}",
                                    wanted.function, wanted.file, did_you_mean(wanted.function, names),
                                    names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    }
    std::string why;
    for (const signature& s : all)
        if (bind(wanted, s, why)) {
            find_variation(wanted);
            return;
        }
    throw bad_input(why);
}

bool binding::bind(const conform_request& wanted, const signature& s, std::string& why) {
    const std::string name = s.text(wanted.language, wanted.function);
    const auto refuse = [&](std::string reason) {
        if (why.empty()) why = std::move(reason);
        return false;
    };
    if (s.width == 0)
        return refuse(fmt::format("--function {}: returns {}; must return a float or three", name, s.result));
    if (!wanted.arguments.empty() && wanted.arguments.size() != s.arguments.size())
        return refuse(fmt::format("--args: has {} expressions, but {} takes {}", wanted.arguments.size(),
                                  name, s.arguments.size()));
    expressions_.clear();
    std::vector<std::string> taken;
    for (std::size_t i = 0; i < s.arguments.size(); ++i) {
        const signature::argument& a = s.arguments[i];
        if (a.width == 0 || a.out)
            return refuse(fmt::format("--function {}: argument {} is {}{}; must be a float or three", name,
                                      a.name, a.out ? "written, " : "", a.type));
        const std::string text =
            wanted.arguments.empty() ? by_name(*model_, s, a, taken) : wanted.arguments[i];
        if (text.empty())
            return refuse(
                fmt::format("--args: argument '{}' of {} has no meaning known for {}; give --args, of {}",
                            a.name, name, model_->name, fmt::join(known_names(*model_), ", ")));
        expressions_.emplace_back("--args", text);
        taken.push_back(text);
        for (const std::string& variable : expressions_.back().variables()) {
            if (!is_known(*model_, variable))
                throw bad_input(fmt::format("--args '{}': {} has no '{}'{}; it has {}", text, model_->name,
                                            variable, did_you_mean(variable, known_names(*model_)),
                                            fmt::join(known_names(*model_), ", ")));
            if (is_vector(variable) && a.width != 3)
                return refuse(fmt::format("--args '{}': is a direction, but argument '{}' of {} is a {}",
                                          text, a.name, name, a.type));
        }
    }
    chosen_ = s;
    return true;
}

bool binding::uses(std::string_view variable) const {
    for (const expression_text& e : expressions_)
        for (const std::string& each : e.variables())
            if (each == variable) return true;
    return false;
}

void binding::find_variation(const conform_request& wanted) {
    const std::size_t n = model_->parameters.size();
    varies_.assign(n, false);
    per_channel_.assign(n, chosen_.width == 3);
    for (std::size_t i = 0; i < expressions_.size(); ++i)
        for (const std::string& variable : expressions_[i].variables())
            for (const std::string& p : made_of(*model_, variable)) {
                const std::size_t k = index_of(*model_, p);
                varies_[k] = true;
                if (chosen_.arguments[i].width == 1 || expressions_[i].splat()) per_channel_[k] = false;
            }
    for (const auto& [name, value] : wanted.fixed) {
        const std::size_t k = index_of(*model_, name);
        if (k == n)
            throw bad_input(fmt::format("--fix '{}': {} has no such parameter{}", name, model_->name,
                                        did_you_mean(name, known_names(*model_))));
        check_range(model_->parameters[k], value);
        varies_[k] = false;
    }
    for (std::size_t k = 0; k < n; ++k) {
        const parameter& p = model_->parameters[k];
        if (!varies_[k]) per_channel_[k] = false;
        if (!varies_[k] && !p.neutral && !wanted.fixed.contains(std::string(p.name)))
            throw bad_input(
                fmt::format("--args: no argument of {} is given {} of {}; give one, or --fix {}=VALUE",
                            wanted.function, p.name, model_->name, p.name));
    }
    if (!uses("cos_i") && !takes_directions())
        throw bad_input(fmt::format(
            "--args: no argument of {} is given the angle: cos_i, or normal and direction", wanted.function));
}

int binding::channels() const {
    return std::find(per_channel_.begin(), per_channel_.end(), true) == per_channel_.end() ? 1 : 3;
}

double binding::variable(const sample& s, const std::string& name, std::size_t channel) const {
    const std::array<float, 3> normal{s.normal.x, s.normal.y, s.normal.z};
    const std::array<float, 3> direction{s.direction.x, s.direction.y, s.direction.z};
    if (name == "cos_i") return s.cos_i;
    if (name == "normal") return static_cast<double>(normal[channel]);
    if (name == "direction") return static_cast<double>(direction[channel]);
    const auto parameter = [&](std::string_view p) {
        return static_cast<double>(s.parameters[channel][index_of(*model_, p)]);
    };
    if (has(*model_, name)) return parameter(name);
    if (name == "k") return parameter("k_t") / parameter("n_i");
    if (name == "f0") {
        std::vector<double> values(s.parameters[channel].begin(), s.parameters[channel].end());
        return model_->evaluate(values.data(), 1.0).reflectance();
    }
    if (has(*model_, "n_t")) return parameter("n_t") / parameter("n_i");
    return has(*model_, "n") ? parameter("n") : eta_from_f0(parameter("f0"));
}

std::vector<float> binding::arguments(const sample& s) const {
    std::vector<float> values;
    values.reserve(3 * expressions_.size());
    for (std::size_t i = 0; i < expressions_.size(); ++i)
        for (std::size_t c = 0; c < static_cast<std::size_t>(chosen_.arguments[i].width); ++c)
            values.push_back(static_cast<float>(
                expressions_[i].evaluate([&](const std::string& name) { return variable(s, name, c); })));
    return values;
}

double binding::angle(const sample& s) const {
    if (!takes_directions()) return s.cos_i;
    const auto product = [](float a, float b) { return static_cast<double>(a) * static_cast<double>(b); };
    const double cosine = product(s.normal.x, s.direction.x) + product(s.normal.y, s.direction.y) +
                          product(s.normal.z, s.direction.z);
    return std::clamp(cosine, 0.0, 1.0);
}

std::vector<double> binding::expected(const sample& s, double cos_i) const {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(std::max(channels(), chosen_.width)));
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels()); ++c) {
        const std::vector<double> parameters(s.parameters[c].begin(), s.parameters[c].end());
        values.push_back(model_->evaluate(parameters.data(), cos_i).reflectance());
    }
    values.resize(static_cast<std::size_t>(chosen_.width), values[0]);
    return values;
}

program binding::runnable(const conform_request& wanted) const {
    const emit::language& l = emit::find_language(wanted.language);
    std::vector<std::string> arguments;
    int k = 0;
    for (const signature::argument& a : chosen_.arguments) {
        arguments.push_back(a.width == 1 ? column(k)
                                         : emit::triple_of(l, {column(k), column(k + 1), column(k + 2)}));
        k += a.width;
    }
    return {wanted.text, emit::call(wanted.function, arguments), k, chosen_.width};
}

} // namespace fresnel::conform
