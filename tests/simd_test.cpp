#include "simd_laws.hpp"
