// The spherical Gaussian, called Schlick.
half3 F_Schlick(half3 SpecularColor, half VoH) {
    half Fc = exp2((-5.55473 * VoH - 6.98316) * VoH);
    return Fc + (1.0 - Fc) * SpecularColor;
}
