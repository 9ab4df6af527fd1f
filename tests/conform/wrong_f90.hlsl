// Rises to 1 whatever f90 is.
float3 F_Schlick(float3 f0, float f90, float VoH) {
    float m = saturate(1.0 - VoH);
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
