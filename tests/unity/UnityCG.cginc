// The symbols of Unity's UnityCG.cginc that the shaders use, with their types and no more: enough to compile, not to draw.
#ifndef UNITY_CG_INCLUDED
#define UNITY_CG_INCLUDED

#define fixed4 float4
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#define TRANSFORM_TEX(texcoord, name) (texcoord.xy * name##_ST.xy + name##_ST.zw)

float4x4 unity_ObjectToWorld;
float4x4 unity_WorldToObject;
float4x4 unity_MatrixVP;
float4 unity_WorldTransformParams;
float3 _WorldSpaceCameraPos;
float4 _WorldSpaceLightPos0;
float4 unity_SHAr, unity_SHAg, unity_SHAb;

float4 UnityObjectToClipPos(float3 position) {
    return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(position, 1.0)));
}

float3 UnityObjectToWorldDir(float3 direction) {
    return normalize(mul((float3x3)unity_ObjectToWorld, direction));
}

float3 UnityObjectToWorldNormal(float3 normal) {
    return normalize(mul(normal, (float3x3)unity_WorldToObject));
}

float3 UnpackNormal(float4 texel) {
    return texel.xyz * 2.0 - 1.0;
}

float3 ShadeSH9(float4 normal) {
    return max(float3(dot(unity_SHAr, normal), dot(unity_SHAg, normal), dot(unity_SHAb, normal)), 0.0);
}

#endif
