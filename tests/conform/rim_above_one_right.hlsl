float rim(float bias, float scale, float power, float NdotV) {
    return saturate(bias + scale * pow(saturate(1.0 - NdotV), power));
}
