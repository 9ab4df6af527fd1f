// The same laws for compilers without vector types.
#define FRESNEL_NO_VECTOR_EXTENSIONS
#define FRESNEL_ISA_NAMESPACE isa_fallback
#include "simd_laws.hpp"
