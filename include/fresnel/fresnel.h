#ifndef FRESNEL_H
#define FRESNEL_H

/*
 * fresnel: reflectance models on arrays, for C and for every language that calls C.
 *
 * Every function may be called from several threads at once, runs on the thread that calls it, allocates nothing,
 * keeps no pointer and throws nothing. Texts that are returned live as long as the program. To use several threads,
 * call from each with a part of the arrays: the results are the same. The floating-point environment of the calling thread
 * must be the default: rounding to nearest, denormals kept (no FTZ or DAZ, which -ffast-math may set for a program).
 *
 * Models are known by name: "dielectric", "conductor", "schlick", "f82", ...; fresnel_model_name lists them, and
 * docs/models.md has the error of each and `fresnel models NAME` its equation. cos_i is the cosine of the angle of incidence, in [0, 1]. The
 * index of the medium that the light comes from is a parameter of the exact models, n_i. A refractive index is n + ik,
 * k >= 0. Reflectances are linear and in [0, 1].
 */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum fresnel_error {
    FRESNEL_OK = 0,
    FRESNEL_UNKNOWN_MODEL = 1, /* no model has that name */
    FRESNEL_BAD_ARGUMENT = 2,  /* a pointer is NULL that may not be, or a stride is neither 0 nor 1 */
    FRESNEL_OUT_OF_RANGE = 3,  /* a value is outside its parameter's range, or an index has no such item */
    FRESNEL_NOT_POLARISED = 4, /* only the exact models have R_s and R_p */
    FRESNEL_BAD_INSTRUCTION_SET = 5 /* the environment's FRESNEL_ISA is not a set that this machine runs */
} fresnel_error;

/* One line about an error code, never NULL. */
const char* fresnel_error_string(fresnel_error error);

/* The version of the library, "1.2.3". */
const char* fresnel_version(void);

/* The instruction set in use: "scalar", "sse2", "avx2", "avx512", "neon" or "simd128". It is the one that the
 * environment variable FRESNEL_ISA names when it is first needed, or else the widest that the machine runs. NULL where
 * FRESNEL_ISA names none that it runs. The results do not depend on it. */
const char* fresnel_isa(void);

/* How many models there are, and the name of each; NULL for an index that is not in [0, count). */
size_t fresnel_model_count(void);
const char* fresnel_model_name(size_t index);

/* A parameter of a model. Its values are meant to be in [min, max], these rounded to float. */
typedef struct fresnel_parameter {
    const char* name;
    const char* unit; /* "1": dimensionless */
    double min, max;
    double default_value;
} fresnel_parameter;

/* How many parameters a model has beside cos_i.
 *   count   where the number goes
 * FRESNEL_UNKNOWN_MODEL, FRESNEL_BAD_ARGUMENT */
fresnel_error fresnel_model_parameter_count(const char* model, size_t* count);

/* One parameter of a model, by its place.
 *   parameter   where it goes
 * FRESNEL_UNKNOWN_MODEL, FRESNEL_BAD_ARGUMENT, FRESNEL_OUT_OF_RANGE */
fresnel_error fresnel_model_parameter(const char* model, size_t index, fresnel_parameter* parameter);

/* Unpolarised reflectance R.
 *
 *   parameters     as many pointers as the model has parameters, in their order, each to `count` floats, or to one if
 *                  its stride is 0; NULL for a model without parameters
 *   strides        for each parameter 1: an array, or 0: one value for all; NULL: all are arrays
 *   cos_i          `count` floats, or one if cos_i_stride is 0
 *   cos_i_stride   1 or 0
 *   count          how many values; where it is 0, nothing is done and every pointer but the model may be NULL
 *   R              `count` floats; may be one of the input arrays, but must not overlap one otherwise, nor another
 *                  output. Single values are read before anything is written, and may lie anywhere.
 *
 * Values are not checked (fresnel_check does that): outside the ranges R is some number or NaN.
 * FRESNEL_UNKNOWN_MODEL, FRESNEL_BAD_ARGUMENT, FRESNEL_BAD_INSTRUCTION_SET; R is then unchanged. */
fresnel_error fresnel_evaluate(const char* model, const float* const* parameters, const size_t* strides,
                               const float* cos_i, size_t cos_i_stride, size_t count, float* R);

/* Reflectance and transmittance per polarisation, of an exact model. R_s and R_p as R above; T_s and T_p both as R, or
 * both NULL. FRESNEL_NOT_POLARISED beside the errors above. */
fresnel_error fresnel_evaluate_polarised(const char* model, const float* const* parameters,
                                         const size_t* strides, const float* cos_i, size_t cos_i_stride,
                                         size_t count, float* R_s, float* R_p, float* T_s, float* T_p);

/* Unpolarised reflectance of three channels that share their angle; errors as fresnel_evaluate's.
 *   parameters, strides   three times as many: those of red, then of green, then of blue
 *   red, green, blue      `count` floats each, as R above */
fresnel_error fresnel_evaluate_rgb(const char* model, const float* const* parameters, const size_t* strides,
                                   const float* cos_i, size_t cos_i_stride, size_t count, float* red,
                                   float* green, float* blue);

/* Finds the first value outside its range, NaN included: of the first parameter that has one, or of cos_i after them,
 * the first in the array. Arguments as fresnel_evaluate's; for three channels, check each of them.
 *   argument   where the place of its parameter goes, the number of parameters for cos_i; may be NULL
 *   index      where its place in the array goes, 0 for a single value; may be NULL
 * FRESNEL_OK where all values are in range; FRESNEL_OUT_OF_RANGE where `argument` and `index` were set;
 * FRESNEL_UNKNOWN_MODEL, FRESNEL_BAD_ARGUMENT */
fresnel_error fresnel_check(const char* model, const float* const* parameters, const size_t* strides,
                            const float* cos_i, size_t cos_i_stride, size_t count, size_t* argument,
                            size_t* index);

#ifdef __cplusplus
}
#endif

#endif
