// accepted
// The same calls as in the refused files, written as number.hpp asks for them.
#include <fresnel/types/strict.hpp>

template <class T>
T model(T x) {
    using namespace fresnel;
    const T half = let("half", x / 2);
    const T small = ratio<T, 1, 25>() * (1 - half);
    const T root = sqrt(select(small < 0, T(1), small));
    return max(min(pow(root, x), T(1)), abs(exp2(x) - log2(2 * x)));
}

template fresnel::strict model(fresnel::strict);
