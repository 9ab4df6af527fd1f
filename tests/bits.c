/* Prints one line per model: a hash of the bits of R, for one colour and for three, over fixed inputs with every edge
 * among them. Built for several machines, it has to print the same on all of them. */

#include <fresnel/fresnel.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { count = 4099, most_parameters = 12 };

static uint64_t state = 1;

/* A number in [0, 1) of 24 bits. */
static float draw(void) {
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (float)(state >> 40) * 0x1p-24f;
}

/* A value of that range: often an end of it, now and then what no one should pass. */
static float value_of(double lo, double hi) {
    const float edges[] = {(float)lo, (float)hi, 1e-40f, 1e-30f, INFINITY, NAN, 0.0f, 1.0f};
    const unsigned choice = (unsigned)(draw() * 64.0f);
    if (choice < sizeof edges / sizeof edges[0]) return edges[choice];
    return (float)lo + draw() * ((float)(hi < 4 ? hi : 4) - (float)lo);
}

static uint64_t hash(uint64_t h, const float* values) {
    int i;
    for (i = 0; i < count; ++i) {
        uint32_t bits = 0x7fc00000; /* any NaN counts as the same */
        if (!isnan(values[i])) memcpy(&bits, &values[i], sizeof bits);
        h = (h ^ bits) * UINT64_C(1099511628211);
    }
    return h;
}

static int print_model(const char* model) {
    static float columns[most_parameters][count], cosines[count], R[3][count];
    const float* parameters[most_parameters];
    uint64_t h = UINT64_C(14695981039346656037);
    size_t n = 0, k, i;
    if (fresnel_model_parameter_count(model, &n) != FRESNEL_OK || 3 * n > most_parameters) return 1;
    for (k = 0; k < 3 * n; ++k) {
        fresnel_parameter p;
        if (fresnel_model_parameter(model, k % n, &p) != FRESNEL_OK) return 1;
        for (i = 0; i < count; ++i)
            columns[k][i] = value_of(p.min, p.max);
        parameters[k] = columns[k];
    }
    for (i = 0; i < count; ++i)
        cosines[i] = value_of(0, 1);
    if (fresnel_evaluate(model, parameters, NULL, cosines, 1, count, R[0]) != FRESNEL_OK) return 1;
    h = hash(h, R[0]);
    if (fresnel_evaluate_rgb(model, parameters, NULL, cosines, 1, count, R[0], R[1], R[2]) != FRESNEL_OK)
        return 1;
    for (k = 0; k < 3; ++k)
        h = hash(h, R[k]);
    printf("%-20s %08x%08x\n", model, (unsigned)(h >> 32), (unsigned)h);
    return 0;
}

int main(void) {
    size_t i;
    fprintf(stderr, "%s\n", fresnel_isa());
    for (i = 0; i < fresnel_model_count(); ++i)
        if (print_model(fresnel_model_name(i)) != 0) {
            fprintf(stderr, "%s failed\n", fresnel_model_name(i));
            return 1;
        }
    return 0;
}
