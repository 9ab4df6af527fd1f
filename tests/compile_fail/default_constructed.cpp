// refused: no matching (function|constructor)
// T sum{} is 0 in double, and no number yet in a batch or a symbol.
#include <fresnel/types/strict.hpp>

template <class T>
T model(T x) {
    T sum{};
    return sum + x;
}

template fresnel::strict model(fresnel::strict);
