// Figure 9 of Wloka 2002: a mirrored environment over a colour, by the reflectance at a normal from a map. The map holds
// components in [-1, 1], in tangent space, and the rows turn them to the world; the eye is given in both.
static const float f0 = 0.02;
sampler normal_map, environment;

float4 fragment_main(float2 at : TEXCOORD0, float3 row_x : TEXCOORD1, float3 row_y : TEXCOORD2, float3 row_z : TEXCOORD3,
                     float3 world_eye : TEXCOORD4, float3 tangent_eye : COLOR0, float4 color : COLOR1) : COLOR {
    float3 normal = tex2D(normal_map, at).xyz;
    float3 world_normal = normalize(float3(dot(row_x, normal), dot(row_y, normal), dot(row_z, normal)));
    float4 mirrored = texCUBE(environment, reflected_direction(world_eye, world_normal));
    return lerp(color, mirrored, schlick(f0, normal, 2.0 * tangent_eye - 1.0));
}
