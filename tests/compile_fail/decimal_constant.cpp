// refused: deleted (function|constructor|member)
// T(0.04) is another number in every T: ratio<T, 4, 100>() is not.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return T(0.04) * x;
}

template fresnel::strict model(fresnel::strict);
