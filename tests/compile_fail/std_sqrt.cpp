// refused: no matching function for call to '(std::)?sqrt
// std::sqrt knows the standard library's numbers only; sqrt finds every number type's own.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return std::sqrt(x);
}

template fresnel::strict model(fresnel::strict);
