// refused: (could not|cannot) convert.*mask|mask. is not contextually convertible to .bool
// std::max asks a comparison for a bool; max does not.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return std::max(x, T(1));
}

template fresnel::strict model(fresnel::strict);
