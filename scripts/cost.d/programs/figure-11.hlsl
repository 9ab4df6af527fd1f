// Figure 11 of Wloka 2002: a mirrored environment over a lit colour, by a texture of reflectance read at the cosine.
sampler base_map, environment, normal_map, fresnel_table;

float4 fragment_main(float2 base_at : TEXCOORD0, float3 mirrored_at : TEXCOORD1, float2 normal_at : TEXCOORD2,
                     float3 direction : TEXCOORD3, float4 diffuse : COLOR0, float4 specular : COLOR1) : COLOR {
    float3 normal = tex2D(normal_map, normal_at).xyz;
    float F = tex2D(fresnel_table, float2(incidence_cosine(normal, direction), 0.5)).a;
    float4 lit = tex2D(base_map, base_at) * diffuse + specular;
    return float4(lerp(lit.rgb, texCUBE(environment, mirrored_at).rgb, F), lit.a);
}
