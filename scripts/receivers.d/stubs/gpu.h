// What CUDA's and HIP's own headers declare and fresnel.cuh uses, so that clang compiles it for a GPU without either.
#pragma once

#define __device__ __attribute__((device))
#define __host__ __attribute__((host))
#define __global__ __attribute__((global))
#define __shared__ __attribute__((shared))
#define __constant__ __attribute__((constant))

struct float2 {
    float x, y;
};
struct float3 {
    float x, y, z;
};
struct float4 {
    float x, y, z, w;
};
struct int2 {
    int x, y;
};
struct uint3 {
    unsigned x, y, z;
};
struct dim3 {
    unsigned x, y, z;
};

inline __host__ __device__ float3 make_float3(float x, float y, float z) { return {x, y, z}; }
inline __host__ __device__ float2 make_float2(float x, float y) { return {x, y}; }

extern "C" {
#define FUNCTION(name) __host__ __device__ float name(float);
FUNCTION(sqrtf) FUNCTION(fabsf) FUNCTION(exp2f) FUNCTION(log2f) FUNCTION(logf) FUNCTION(expf) FUNCTION(sinf)
FUNCTION(cosf) FUNCTION(tanf) FUNCTION(rsqrtf) FUNCTION(floorf) FUNCTION(ceilf) FUNCTION(acosf) FUNCTION(asinf)
#undef FUNCTION
#define FUNCTION(name) __host__ __device__ float name(float, float);
FUNCTION(fminf) FUNCTION(fmaxf) FUNCTION(powf) FUNCTION(fmodf) FUNCTION(atan2f) FUNCTION(hypotf) FUNCTION(copysignf)
FUNCTION(fdimf) FUNCTION(fdividef) FUNCTION(rhypotf) FUNCTION(nextafterf) FUNCTION(remainderf)
#undef FUNCTION
#define FUNCTION(name) __host__ __device__ double name(double);
FUNCTION(sqrt) FUNCTION(fabs) FUNCTION(exp2) FUNCTION(log2) FUNCTION(log) FUNCTION(exp) FUNCTION(sin) FUNCTION(cos)
FUNCTION(tan) FUNCTION(rsqrt) FUNCTION(floor) FUNCTION(ceil) FUNCTION(acos) FUNCTION(asin)
#undef FUNCTION
}
