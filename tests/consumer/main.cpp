#include <fresnel/approx.hpp>
#include <fresnel/average.hpp>
#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/models.hpp>
#include <fresnel/types/strict.hpp>

#include <cmath>

/// Succeeds if glass reflects 4 percent straight on, whichever way it is asked.
int main() {
    const float exact = fresnel::dielectric(1.0f, 1.5f, 1.0f).reflectance();
    const float f0 = fresnel::normal_reflectance(1.0f, 1.5f, 0.0f);
    const float schlick = fresnel::schlick(f0, 1.0f);
    int models = 0;
    fresnel::for_each_model([&](const auto&) { ++models; });
    const bool right = std::abs(exact - 0.04f) < 1e-8f && std::abs(schlick - 0.04f) < 1e-8f && models > 0;
    return right ? 0 : 1;
}
