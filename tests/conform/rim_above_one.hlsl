// The rim of many game shaders, not limited to [0, 1].
float rim(float bias, float scale, float power, float NdotV) {
    return bias + scale * pow(saturate(1.0 - NdotV), power);
}
