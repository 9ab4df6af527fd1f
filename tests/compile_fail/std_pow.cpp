// refused: no matching function for call to '(std::)?pow
// std::pow knows the standard library's numbers only; pow finds every number type's own.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return std::pow(x, T(5));
}

template fresnel::strict model(fresnel::strict);
