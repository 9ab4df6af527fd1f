// refused: deleted (function|constructor|member)
// 0.5 * x silently turns a float model into a double one.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return 0.5 * x;
}

template fresnel::strict model(fresnel::strict);
