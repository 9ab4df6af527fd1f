// refused: (could not|cannot) convert.*mask|mask. is not contextually convertible to .bool
// select(x > 1, a, b) takes the place of ?: as well.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return x > 1 ? x : 1 - x;
}

template fresnel::strict model(fresnel::strict);
