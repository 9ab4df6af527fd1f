/* The C functions, from C99. Exits with 1 and a line per failure. `c_abi SET`, run with FRESNEL_ISA=SET: the same with
 * that instruction set, or that one which there is not is an error; exits with 77 where the machine lacks it. */

#include <fresnel/fresnel.h>

#include <stdio.h>
#include <string.h>

static int failures = 0;

#define EXPECT(condition)                                                                                    \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            printf("%s:%d: %s\n", __FILE__, __LINE__, #condition);                                           \
            ++failures;                                                                                      \
        }                                                                                                    \
    } while (0)

enum { count = 37 };

static float cosines[count];

static int close_to(double actual, double expected) {
    const double difference = actual - expected;
    return -1e-6 < difference && difference < 1e-6;
}

static double pow5(double x) { return x * x * x * x * x; }

static void test_models(void) {
    size_t parameters = 0;
    fresnel_parameter p;
    EXPECT(strlen(fresnel_version()) >= 5);
    EXPECT(fresnel_model_count() >= 26);
    EXPECT(strcmp(fresnel_model_name(0), "dielectric") == 0);
    EXPECT(fresnel_model_name(fresnel_model_count()) == NULL);
    EXPECT(fresnel_model_parameter_count("conductor", &parameters) == FRESNEL_OK);
    EXPECT(parameters == 3);
    EXPECT(fresnel_model_parameter_count("nothing", &parameters) == FRESNEL_UNKNOWN_MODEL);
    EXPECT(fresnel_model_parameter_count(NULL, &parameters) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_model_parameter_count("conductor", NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_model_parameter("conductor", 2, &p) == FRESNEL_OK);
    EXPECT(strcmp(p.name, "k_t") == 0);
    EXPECT(strcmp(p.unit, "1") == 0);
    EXPECT(p.min <= p.default_value && p.default_value <= p.max);
    EXPECT(fresnel_model_parameter("conductor", 3, &p) == FRESNEL_OUT_OF_RANGE);
    EXPECT(fresnel_model_parameter("conductor", 0, NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_model_parameter("nothing", 0, &p) == FRESNEL_UNKNOWN_MODEL);
    EXPECT(fresnel_model_parameter(NULL, 0, &p) == FRESNEL_BAD_ARGUMENT);
}

static void test_evaluate(void) {
    const float f0 = 0.04f;
    const float* const parameters[] = {&f0};
    const size_t single[] = {0};
    float R[count];
    int i;
    EXPECT(fresnel_evaluate("schlick", parameters, single, cosines, 1, count, R) == FRESNEL_OK);
    for (i = 0; i < count; ++i)
        EXPECT(close_to((double)R[i], 0.04 + 0.96 * pow5(1 - (double)cosines[i])));
    EXPECT(fresnel_evaluate("one_minus_cos", NULL, NULL, cosines, 1, count, R) == FRESNEL_OK);
    EXPECT(R[count - 1] == 1 - cosines[count - 1]);
    EXPECT(fresnel_evaluate("schlick", parameters, single, cosines, 0, count, R) == FRESNEL_OK);
    EXPECT(R[count - 1] == 1); /* cos_i = 0 throughout */
}

static void test_single_value_in_results(void) {
    const size_t single[] = {0};
    float R[count];
    const float* const parameters[] = {R};
    int i;
    R[0] = 0.04f;
    EXPECT(fresnel_evaluate("schlick", parameters, single, cosines, 1, count, R) == FRESNEL_OK);
    for (i = 0; i < count; ++i)
        EXPECT(close_to((double)R[i], 0.04 + 0.96 * pow5(1 - (double)cosines[i])));
}

static void test_polarised(void) {
    const float n_i = 1, n_t = 1.5f;
    const float* const parameters[] = {&n_i, &n_t};
    const size_t single[] = {0, 0};
    float R_s[count], R_p[count], T_s[count], T_p[count];
    int i;
    EXPECT(fresnel_evaluate_polarised("dielectric", parameters, single, cosines, 1, count, R_s, R_p, T_s,
                                      T_p) == FRESNEL_OK);
    for (i = 0; i < count; ++i) {
        EXPECT(close_to((double)R_s[i] + (double)T_s[i], 1));
        EXPECT(close_to((double)R_p[i] + (double)T_p[i], 1));
        EXPECT(R_p[i] <= R_s[i]);
    }
    EXPECT(fresnel_evaluate_polarised("dielectric", parameters, single, cosines, 1, count, R_s, R_p, NULL,
                                      NULL) == FRESNEL_OK);
    EXPECT(fresnel_evaluate_polarised("dielectric", parameters, single, cosines, 1, count, R_s, R_p, T_s,
                                      NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate_polarised("schlick", parameters, single, cosines, 1, count, R_s, R_p, NULL,
                                      NULL) == FRESNEL_NOT_POLARISED);
}

static void test_rgb(void) {
    const float gold[] = {1.0f, 0.78f, 0.34f};
    const float* const parameters[] = {gold, gold + 1, gold + 2};
    const size_t single[] = {0, 0, 0};
    float R[3][count], one[count];
    int channel;
    EXPECT(fresnel_evaluate_rgb("schlick", parameters, single, cosines, 1, count, R[0], R[1], R[2]) ==
           FRESNEL_OK);
    for (channel = 0; channel < 3; ++channel) {
        EXPECT(fresnel_evaluate("schlick", parameters + channel, single, cosines, 1, count, one) ==
               FRESNEL_OK);
        EXPECT(memcmp(one, R[channel], sizeof one) == 0);
    }
    EXPECT(fresnel_evaluate_rgb("schlick", parameters, single, cosines, 1, count, R[0], NULL, R[2]) ==
           FRESNEL_BAD_ARGUMENT);
}

static void test_bad_use(void) {
    const float f0[] = {0.04f, 0.5f, 1.0f};
    const float* const parameters[] = {f0};
    const float* const none[] = {NULL};
    const size_t two[] = {2};
    float R[3] = {7, 7, 7};
    int code;
    EXPECT(fresnel_evaluate("nothing", parameters, NULL, cosines, 1, 3, R) == FRESNEL_UNKNOWN_MODEL);
    EXPECT(fresnel_evaluate(NULL, parameters, NULL, cosines, 1, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", NULL, NULL, cosines, 1, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", none, NULL, cosines, 1, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", parameters, two, cosines, 1, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", parameters, NULL, NULL, 1, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", parameters, NULL, cosines, 2, 3, R) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_evaluate("schlick", parameters, NULL, cosines, 1, 3, NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(R[0] == 7 && R[1] == 7 && R[2] == 7);

    EXPECT(fresnel_evaluate("schlick", NULL, NULL, NULL, 1, 0, NULL) == FRESNEL_OK);
    EXPECT(fresnel_evaluate("schlick", NULL, NULL, NULL, 0, 0, NULL) == FRESNEL_OK);
    EXPECT(fresnel_evaluate("nothing", NULL, NULL, NULL, 1, 0, NULL) == FRESNEL_UNKNOWN_MODEL);

    for (code = FRESNEL_OK; code <= FRESNEL_BAD_INSTRUCTION_SET + 1; ++code)
        EXPECT(strlen(fresnel_error_string((fresnel_error)code)) > 5);
}

static void test_check(void) {
    const float f0[] = {0.04f, 0.5f, 1.5f}, backwards[] = {1, 0.5f, -0.1f}, n_i = 0.01f, low = 0.009f;
    const float zero = 0, not_a_number = zero / zero;
    const float* const parameters[] = {f0};
    const float* const smallest[] = {&n_i, f0};
    const float* const too_small[] = {&low, f0};
    const float* const nan_first[] = {&not_a_number};
    const size_t strides[] = {0, 1}, two[] = {2};
    size_t argument = 9, index = 9;
    EXPECT(fresnel_check("schlick", parameters, NULL, cosines, 1, 2, &argument, &index) == FRESNEL_OK);
    EXPECT(fresnel_check("dielectric", smallest, strides, cosines, 1, 3, &argument, &index) == FRESNEL_OK);
    EXPECT(argument == 9 && index == 9);
    EXPECT(fresnel_check("schlick", parameters, NULL, backwards, 1, 3, &argument, &index) ==
           FRESNEL_OUT_OF_RANGE);
    EXPECT(argument == 0 && index == 2);
    EXPECT(fresnel_check("schlick", parameters, NULL, backwards, 1, 2, NULL, NULL) == FRESNEL_OK);
    EXPECT(fresnel_check("one_minus_cos", NULL, NULL, backwards, 1, 3, &argument, NULL) ==
           FRESNEL_OUT_OF_RANGE);
    EXPECT(argument == 0);
    EXPECT(fresnel_check("dielectric", too_small, strides, backwards, 1, 3, &argument, &index) ==
           FRESNEL_OUT_OF_RANGE);
    EXPECT(argument == 0 && index == 0);
    EXPECT(fresnel_check("dielectric", smallest, strides, backwards, 1, 3, &argument, &index) ==
           FRESNEL_OUT_OF_RANGE);
    EXPECT(argument == 2 && index == 2);
    EXPECT(fresnel_check("schlick", nan_first, strides, cosines, 1, 3, NULL, NULL) == FRESNEL_OUT_OF_RANGE);
    EXPECT(fresnel_check("schlick", parameters, two, cosines, 1, 3, NULL, NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_check("schlick", NULL, NULL, cosines, 1, 3, NULL, NULL) == FRESNEL_BAD_ARGUMENT);
    EXPECT(fresnel_check("nothing", NULL, NULL, cosines, 1, 3, NULL, NULL) == FRESNEL_UNKNOWN_MODEL);
    EXPECT(fresnel_check("schlick", NULL, NULL, NULL, 0, 0, NULL, NULL) == FRESNEL_OK);
}

static int names(const char* set, const char* name) { return strcmp(set, name) == 0; }

/* 1 or 0; -1 for what is no instruction set. Asks the processor, not the library. */
static int machine_runs(const char* set) {
    if (names(set, "scalar")) return 1;
#if defined(__x86_64__)
    if (names(set, "sse2")) return 1;
    if (names(set, "avx2")) return __builtin_cpu_supports("avx2") != 0;
    if (names(set, "avx512"))
        return __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512bw");
#elif defined(__aarch64__)
    if (names(set, "neon")) return 1;
#elif defined(__wasm__)
    if (names(set, "simd128")) return 1;
#endif
    const int known = names(set, "sse2") || names(set, "avx2") || names(set, "avx512") ||
                      names(set, "neon") || names(set, "simd128");
    return known ? 0 : -1;
}

static void test_no_such_isa(void) {
    const float f0 = 0.04f;
    const float* const parameters[] = {&f0};
    float R = 7;
    EXPECT(fresnel_isa() == NULL);
    EXPECT(fresnel_evaluate("schlick", parameters, NULL, cosines, 1, 1, &R) == FRESNEL_BAD_INSTRUCTION_SET);
    EXPECT(fresnel_evaluate("schlick", NULL, NULL, NULL, 1, 0, NULL) == FRESNEL_BAD_INSTRUCTION_SET);
    EXPECT(R == 7);
    EXPECT(fresnel_check("schlick", parameters, NULL, cosines, 1, 1, NULL, NULL) == FRESNEL_OK);
}

static void test_all(void) {
    EXPECT(fresnel_isa() != NULL);
    test_models();
    test_evaluate();
    test_single_value_in_results();
    test_polarised();
    test_rgb();
    test_bad_use();
    test_check();
}

int main(int argc, char** argv) {
    const char* set = argc > 1 ? argv[1] : "scalar";
    int i;
    for (i = 0; i < count; ++i)
        cosines[i] = (float)i / (float)(count - 1);
    if (machine_runs(set) == 0) {
        printf("this machine does not run %s\n", set);
        EXPECT(fresnel_isa() == NULL);
        return failures > 0 ? 1 : 77;
    }
    if (machine_runs(set) < 0) {
        test_no_such_isa();
    } else {
        test_all();
        EXPECT(argc == 1 || strcmp(fresnel_isa(), set) == 0);
    }
    return failures > 0;
}
