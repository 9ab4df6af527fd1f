// refused: deleted (function|member)
// A single value is read at the call, when the float that a double was converted to is gone.
#include "../../src/batch/batch.hpp"

fresnel::batch_argument index(double n) { return fresnel::batch_argument::same(n); }
