// refused: deleted (function|constructor|member)
// 1.0f - x silently takes digits from a double model.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return 1.0f - x;
}

template fresnel::strict model(fresnel::strict);
