// The symbols of URP's Lighting.hlsl that the shaders use.
#ifndef UNIVERSAL_LIGHTING_INCLUDED
#define UNIVERSAL_LIGHTING_INCLUDED

struct Light {
    float3 direction;
    float3 color;
    float distanceAttenuation;
    float shadowAttenuation;
};

float4 _MainLightPosition, _MainLightColor;
float4 _AdditionalLightsCount;
float4 _AdditionalLightsPosition[16], _AdditionalLightsColor[16];
float4 unity_SHAr, unity_SHAg, unity_SHAb;

Light GetMainLight() {
    Light light;
    light.direction = _MainLightPosition.xyz;
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1.0;
    light.shadowAttenuation = 1.0;
    return light;
}

int GetAdditionalLightsCount() {
    return int(_AdditionalLightsCount.x);
}

Light GetAdditionalLight(uint i, float3 position) {
    float3 to_light = _AdditionalLightsPosition[i].xyz - position * _AdditionalLightsPosition[i].w;
    Light light;
    light.direction = normalize(to_light);
    light.color = _AdditionalLightsColor[i].rgb;
    light.distanceAttenuation = 1.0 / dot(to_light, to_light);
    light.shadowAttenuation = 1.0;
    return light;
}

float3 SampleSH(float3 normal) {
    float4 n = float4(normal, 1.0);
    return max(float3(dot(unity_SHAr, n), dot(unity_SHAg, n), dot(unity_SHAb, n)), 0.0);
}

#endif
