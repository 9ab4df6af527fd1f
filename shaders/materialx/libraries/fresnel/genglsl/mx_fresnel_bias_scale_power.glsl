#ifndef FRESNEL_BIAS_SCALE_POWER
#define FRESNEL_BIAS_SCALE_POWER

// The rim of game shaders.
//
//   F = saturate(bias + scale x^power), x = 1 - cos_i
//
// bias    value at normal incidence, [-10, 10]
// scale   strength of the rim, [-10, 10]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.147, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    14 operations
// source  Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading
float fresnel_bias_scale_power(float bias, float scale, float power, float cos_i) {
    return clamp(bias + scale * pow(1.0 - cos_i, power), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_bias_scale_power(vec3 bias, vec3 scale, vec3 power, float cos_i) {
    return clamp(bias + scale * pow(vec3(1.0 - cos_i), power), 0.0, 1.0);
}

void mx_fresnel_bias_scale_power_cos_float(float bias, float scale, float power, float cos_i, out float result) {
    result = fresnel_bias_scale_power(bias, scale, power, cos_i);
}

void mx_fresnel_bias_scale_power_cos_color3(vec3 bias, vec3 scale, vec3 power, float cos_i, out vec3 result) {
    result = fresnel_bias_scale_power(bias, scale, power, cos_i);
}

#endif
