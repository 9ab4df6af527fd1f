/* Prints one line per model: its name and a hash of the bits of all its results, over fixed inputs with every edge
 * among them. Built for several machines, it has to print the same on all of them. On stderr the instruction set;
 * exits with 77 where the machine lacks the one that FRESNEL_ISA names. */

#include <fresnel/fresnel.h>

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* a prime: whatever the width, some values are left over */
enum { count = 4099, most_inputs = 16, most_outputs = 4 };

static uint64_t state = 1;

/* A number in [0, 1) of 24 bits. */
static float draw(void) {
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (float)(state >> 40) * 0x1p-24f;
}

/* A value of that range: every fourth an end of it, or what no one should pass. */
static float value_of(double lo, double hi) {
    const float edges[] = {(float)lo, (float)hi, 0.0f,   -0.0f,  1.0f,    -1.0f,    1e-40f,    -1e-40f,
                           FLT_MIN,   1e-30f,    1e-10f, 1e+10f, FLT_MAX, INFINITY, -INFINITY, NAN};
    const unsigned choice = (unsigned)(draw() * 64.0f);
    if (choice < sizeof edges / sizeof edges[0]) return edges[choice];
    return (float)lo + draw() * ((float)(hi < 4 ? hi : 4) - (float)lo);
}

static void fill(float* values, double lo, double hi) {
    int i;
    for (i = 0; i < count; ++i)
        values[i] = value_of(lo, hi);
}

static uint64_t hash(uint64_t h, float outputs[][count], int n) {
    int k, i;
    for (k = 0; k < n; ++k)
        for (i = 0; i < count; ++i) {
            uint32_t bits = 0x7fc00000; /* any NaN counts as the same */
            const int is_number = outputs[k][i] == outputs[k][i];
            if (is_number) memcpy(&bits, &outputs[k][i], sizeof bits);
            h = (h ^ bits) * UINT64_C(1099511628211);
        }
    return h;
}

/* 0, or -1 where the library refuses a call. */
static int print_model(const char* model) {
    static float inputs[most_inputs][count], cosines[count], out[most_outputs][count];
    const float* parameters[most_inputs];
    uint64_t h = UINT64_C(14695981039346656037);
    size_t n = 0, k;
    fresnel_error error;
    if (fresnel_model_parameter_count(model, &n) != FRESNEL_OK || 3 * n > most_inputs) return -1;
    for (k = 0; k < 3 * n; ++k) {
        fresnel_parameter p;
        if (fresnel_model_parameter(model, k % n, &p) != FRESNEL_OK) return -1;
        fill(inputs[k], p.min, p.max);
        parameters[k] = inputs[k];
    }
    fill(cosines, 0, 1);

    if (fresnel_evaluate(model, parameters, NULL, cosines, 1, count, out[0]) != FRESNEL_OK) return -1;
    h = hash(h, out, 1);
    if (fresnel_evaluate_rgb(model, parameters, NULL, cosines, 1, count, out[0], out[1], out[2]) !=
        FRESNEL_OK)
        return -1;
    h = hash(h, out, 3);
    error =
        fresnel_evaluate_polarised(model, parameters, NULL, cosines, 1, count, out[0], out[1], NULL, NULL);
    if (error == FRESNEL_OK) {
        h = hash(h, out, 2);
        error = fresnel_evaluate_polarised(model, parameters, NULL, cosines, 1, count, out[0], out[1], out[2],
                                           out[3]);
        h = hash(h, out, 4);
    }
    if (error != FRESNEL_OK && error != FRESNEL_NOT_POLARISED) return -1;
    printf("%-20s %08x%08x\n", model, (unsigned)(h >> 32), (unsigned)h);
    return 0;
}

int main(void) {
    size_t i;
    if (!fresnel_isa()) return 77;
    fprintf(stderr, "%s\n", fresnel_isa());
    for (i = 0; i < fresnel_model_count(); ++i)
        if (print_model(fresnel_model_name(i)) != 0) {
            fprintf(stderr, "%s failed\n", fresnel_model_name(i));
            return 1;
        }
    return 0;
}
