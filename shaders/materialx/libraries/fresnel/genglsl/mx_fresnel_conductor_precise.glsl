#ifndef FRESNEL_CONDUCTOR_PRECISE
#define FRESNEL_CONDUCTOR_PRECISE

// Exact reflectance of any medium, with the two sums that cancel in twice the digits.
//
//   F = as conductor, with the sums that cancel in twice the digits
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
float fresnel_conductor_precise(float n_i, float n_t, float k_t, float cos_i) {
    float n_t2 = n_t * n_t;
    float k_t2 = k_t * k_t;
    float t = n_t2 + (-k_t2);
    float t_2 = t - n_t2;
    float t_3 = 4097.0 * n_t;
    float t_4 = t_3 - (t_3 - n_t);
    float t_5 = n_t - t_4;
    float t_6 = t_4 * t_5;
    float t_7 = t_4 * t_4 - n_t2 + t_6 + t_6 + t_5 * t_5;
    float t_8 = 4097.0 * k_t;
    float t_9 = t_8 - (t_8 - k_t);
    float t_10 = k_t - t_9;
    float t_11 = t_9 * t_10;
    float t_12 = t_9 * t_9 - k_t2 + t_11 + t_11 + t_10 * t_10;
    float t_13 = t_7 + (-t_12);
    float t_14 = n_t2 - (t - t_2) + (-k_t2 - t_2) + t_13;
    float t_15 = t + t_14;
    float t_16 = t_15 - t;
    float t_17 = t_13 - t_7;
    float t_18 = t - (t_15 - t_16) + (t_14 - t_16) + (t_7 - (t_13 - t_17) + (-t_12 - t_17));
    float t_19 = t_15 + t_18;
    float n_i2 = n_i * n_i;
    float t_20 = t_19 + (-n_i2);
    float t_21 = t_20 - t_19;
    float t_22 = t_19 - t_15;
    float t_23 = t_15 - (t_19 - t_22) + (t_18 - t_22);
    float t_24 = 4097.0 * n_i;
    float t_25 = t_24 - (t_24 - n_i);
    float t_26 = n_i - t_25;
    float t_27 = t_25 * t_26;
    float t_28 = t_25 * t_25 - n_i2 + t_27 + t_27 + t_26 * t_26;
    float t_29 = t_23 + (-t_28);
    float t_30 = t_19 - (t_20 - t_21) + (-n_i2 - t_21) + t_29;
    float t_31 = t_20 + t_30;
    float t_32 = t_31 - t_20;
    float t_33 = t_29 - t_23;
    float t_34 = t_20 - (t_31 - t_32) + (t_30 - t_32) + (t_23 - (t_29 - t_33) + (-t_28 - t_33));
    float t_35 = t_31 + t_34;
    float cos2 = cos_i * cos_i;
    float t_36 = n_i2 * cos2;
    float t_37 = 4097.0 * n_i2;
    float t_38 = t_37 - (t_37 - n_i2);
    float t_39 = 4097.0 * cos2;
    float t_40 = t_39 - (t_39 - cos2);
    float t_41 = cos2 - t_40;
    float t_42 = n_i2 - t_38;
    float t_43 = 4097.0 * cos_i;
    float t_44 = t_43 - (t_43 - cos_i);
    float t_45 = cos_i - t_44;
    float t_46 = t_44 * t_45;
    float t_47 = t_44 * t_44 - cos2 + t_46 + t_46 + t_45 * t_45;
    float t_48 = t_38 * t_40 - t_36 + t_38 * t_41 + t_42 * t_40 + t_42 * t_41 + (n_i2 * t_47 + t_28 * cos2);
    float t_49 = t_36 + t_48;
    float t_50 = t_35 + t_49;
    float t_51 = t_50 - t_35;
    float t_52 = t_35 - t_31;
    float t_53 = t_31 - (t_35 - t_52) + (t_34 - t_52);
    float t_54 = t_49 - t_36;
    float t_55 = t_36 - (t_49 - t_54) + (t_48 - t_54);
    float t_56 = t_53 + t_55;
    float t_57 = t_35 - (t_50 - t_51) + (t_49 - t_51) + t_56;
    float t_58 = t_50 + t_57;
    float t_59 = t_58 - t_50;
    float t_60 = t_56 - t_53;
    float t_61 = t_58 + (t_50 - (t_58 - t_59) + (t_57 - t_59) + (t_53 - (t_56 - t_60) + (t_55 - t_60)));
    float t_62 = n_t * k_t;
    float t_63 = abs(t_61);
    float t_64 = sqrt((max(sqrt(t_61 * t_61 + 4.0 * (t_62 * t_62)), t_63) + t_63) / 2.0);
    float t_65 = t_62 / (t_64 > 0.0 ? t_64 : 1.0);
    float t_66 = t_61 < 0.0 ? t_65 : t_64;
    float t_67 = n_i * cos_i;
    float t_68 = t_66 - t_67;
    float t_69 = t_61 < 0.0 ? t_64 : t_65;
    float t_70 = t_69 * t_69;
    float t_71 = t_66 + t_67;
    float t_72 = max(2.0 * abs(t_68), t_69) < t_67 ? (t_35 + t_70) / t_71 : t_68;
    float t_73 = t_71 * t_71 + t_70;
    float t_74 = (t_72 * t_72 + t_70) / (t_73 <= 0.0 ? 1.0 : t_73);
    float t_75 = t_66 * cos_i;
    float t_76 = n_i * ((1.0 - cos_i) * (1.0 + cos_i));
    float t_77 = t_75 - t_76;
    float t_78 = n_t2 + n_i2;
    float t_79 = t_78 - n_t2;
    float t_80 = t_7 + t_28;
    float t_81 = n_t2 - (t_78 - t_79) + (n_i2 - t_79) + t_80;
    float t_82 = t_78 + t_81;
    float t_83 = t_82 - t_78;
    float t_84 = t_80 - t_7;
    float t_85 = t_78 - (t_82 - t_83) + (t_81 - t_83) + (t_7 - (t_80 - t_84) + (t_28 - t_84));
    float t_86 = t_82 + t_85;
    float t_87 = cos2 * t_86;
    float t_88 = 4097.0 * t_86;
    float t_89 = t_88 - (t_88 - t_86);
    float t_90 = t_86 - t_89;
    float t_91 = t_86 - t_82;
    float t_92 = t_40 * t_89 - t_87 + t_40 * t_90 + t_41 * t_89 + t_41 * t_90 +
            (cos2 * (t_82 - (t_86 - t_91) + (t_85 - t_91)) + t_47 * t_86);
    float t_93 = t_87 + t_92;
    float t_94 = t_93 + (-n_i2);
    float t_95 = t_94 - t_93;
    float t_96 = t_93 - t_87;
    float t_97 = t_87 - (t_93 - t_96) + (t_92 - t_96);
    float t_98 = t_97 + (-t_28);
    float t_99 = t_93 - (t_94 - t_95) + (-n_i2 - t_95) + t_98;
    float t_100 = t_94 + t_99;
    float t_101 = t_100 - t_94;
    float t_102 = t_98 - t_97;
    float t_103 = t_75 + t_76;
    float t_104 = t_103 <= 0.0 ? 1.0 : t_103;
    float t_105 = max(2.0 * abs(t_77) - t_76, 2.0 * t_69 - n_i) < 0.0 ?
            (t_100 + (t_94 - (t_100 - t_101) + (t_99 - t_101) + (t_97 - (t_98 - t_102) + (-t_28 - t_102))) +
            cos2 * (t_70 - k_t2)) / t_104 : t_77;
    float t_106 = t_69 * cos_i;
    float t_107 = t_106 * t_106;
    return (min(t_74, 1.0) + min(t_74 * ((t_105 * t_105 + t_107) / (t_104 * t_104 + t_107)), 1.0)) / 2.0;
}

// The same for three channels, which share the angle.
vec3 fresnel_conductor_precise(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(fresnel_conductor_precise(n_i, n_t.x, k_t.x, cos_i),
            fresnel_conductor_precise(n_i, n_t.y, k_t.y, cos_i),
            fresnel_conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}

void mx_fresnel_conductor_precise_cos_float(float n_i, float n_t, float k_t, float cos_i, out float result) {
    result = fresnel_conductor_precise(n_i, n_t, k_t, cos_i);
}

void mx_fresnel_conductor_precise_cos_color3(float n_i, vec3 n_t, vec3 k_t, float cos_i, out vec3 result) {
    result = fresnel_conductor_precise(n_i, n_t, k_t, cos_i);
}

#endif
