// refused: (could not|cannot) convert.*mask|mask. is not contextually convertible to .bool
// A batch or a symbol takes both branches at once: select(x > 1, a, b).
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    if (x > 1) return x;
    return 1 - x;
}

template fresnel::strict model(fresnel::strict);
