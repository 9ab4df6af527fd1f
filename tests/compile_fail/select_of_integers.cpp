// refused: (use of|call to) deleted function
// An integer beside a number: of T = double the call would be another function's.
#include <fresnel/types/strict.hpp>

template <class T>
T model(T x) {
    return select(x < 1, 1, 2) / 2;
}

template fresnel::strict model(fresnel::strict);
