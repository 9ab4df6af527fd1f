// Figure 6 of Wloka 2002: reflectance at a vertex, into the diffuse alpha.
static const float f0 = 0.02;

void vertex_main(float4 at : POSITION, float3 normal : NORMAL, float3 direction : TEXCOORD0, out float4 place : POSITION,
                 out float4 diffuse : COLOR0) {
    place = at;
    diffuse = float4(0.0, 0.0, 0.0, schlick(f0, normal, direction));
}
