#include "fits.hpp"

#include "analysis/compare.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <vector>

namespace fresnel::bench {
namespace {

/// A material's colours and the models to fit to each.
struct job {
    std::vector<std::string_view> models;
    std::array<channel, 3> channels;

    explicit job(const comparison& of) : models(models_for(of.surface)) {
        for (std::size_t i = 0; i < 3; ++i)
            channels[i] = channel_of(of.exact, of.colour.f0, of.colour.f82, 1, i);
    }

    int run() const {
        int fits = 0;
        for (const channel& exact : channels) {
            const edge_tint tint = fit_gulbrandsen(exact);
            for (const std::string_view model : models)
                fits += fit(model, exact, tint).empty() ? 0 : 1;
            for (const std::string_view model : {"f82", "powers_4_12", "powers_2_8_16"})
                fits += fit_f82(model, exact).empty() ? 0 : 1;
        }
        return fits;
    }
};

} // namespace

std::function<int()> all_fits() {
    const auto jobs = std::make_shared<std::vector<job>>();
    for (const material& substance : builtin_materials())
        jobs->emplace_back(compare(substance, color_space::srgb, 1));
    return [jobs] {
        int fits = 0;
        for (const job& one : *jobs)
            fits += one.run();
        return fits;
    };
}

} // namespace fresnel::bench
