// The symbols of URP's Core.hlsl that the shaders use, with their types and no more: enough to compile, not to draw.
#ifndef UNIVERSAL_PIPELINE_CORE_INCLUDED
#define UNIVERSAL_PIPELINE_CORE_INCLUDED

#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#define TRANSFORM_TEX(texcoord, name) ((texcoord.xy) * name##_ST.xy + name##_ST.zw)
#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define TEXTURE2D(name) Texture2D name
#define TEXTURECUBE(name) TextureCube name
#define SAMPLER(name) SamplerState name
#define SAMPLE_TEXTURE2D(name, sampler_name, at) name.Sample(sampler_name, at)
#define SAMPLE_TEXTURECUBE(name, sampler_name, at) name.Sample(sampler_name, at)

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4x4 unity_MatrixVP;
float4 unity_WorldTransformParams;
float3 _WorldSpaceCameraPos;

float3 TransformObjectToWorld(float3 position) {
    return mul(unity_ObjectToWorld, float4(position, 1.0)).xyz;
}

float4 TransformWorldToHClip(float3 position) {
    return mul(unity_MatrixVP, float4(position, 1.0));
}

float3 TransformObjectToWorldNormal(float3 normal, bool normalized = true) {
    return normalize(mul(normal, (float3x3)unity_WorldToObject));
}

float3 TransformObjectToWorldDir(float3 direction, bool normalized = true) {
    return normalize(mul((float3x3)unity_ObjectToWorld, direction));
}

float GetOddNegativeScale() {
    return unity_WorldTransformParams.w >= 0.0 ? 1.0 : -1.0;
}

float3 GetWorldSpaceNormalizeViewDir(float3 position) {
    return normalize(_WorldSpaceCameraPos - position);
}

float3 UnpackNormal(float4 texel) {
    return texel.xyz * 2.0 - 1.0;
}

float2 PackNormalOctQuadEncode(float3 normal) {
    return normal.xy / dot(abs(normal), 1.0);
}

float3 PackFloat2To888(float2 x) {
    return float3(x, 0.0);
}

#endif
