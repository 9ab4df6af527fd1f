struct fresnel_boundary {
    float R_s, R_p; // reflected, polarised across and along the plane of incidence
    float T_s, T_p; // transmitted
};
