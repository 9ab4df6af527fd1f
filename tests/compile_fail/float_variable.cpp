// refused: (cannot convert|no viable conversion).*number. to .const float
// A float between two steps of a model loses the digits of every wider type.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    const float y = x;
    return T(static_cast<int>(y));
}

template fresnel::strict model(fresnel::strict);
