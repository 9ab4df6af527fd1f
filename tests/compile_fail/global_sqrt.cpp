// refused: (cannot convert|no matching function|no viable conversion).*(number|sqrt)
// ::sqrt is the double function of C.
#include <fresnel/types/strict.hpp>

#include <algorithm>
#include <math.h>

template <class T>
T model(T x) {
    return ::sqrt(x);
}

template fresnel::strict model(fresnel::strict);
