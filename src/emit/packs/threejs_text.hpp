#pragma once

#include <string_view>

// What the three.js pack holds beside functions and tables: our own code around them.

namespace fresnel::emit {

/// Behind the tables of fresnel.js: chunks, materials.
inline constexpr std::string_view threejs_glsl_code = R"(
// ---- chunks for shaders of your own -------------------------------------------------------------------------------------

const guarded = (name, text) => `#ifndef ${name}\n#define ${name}\n${text}#endif\n`;

function known(model) {
    if (!(model in functions)) throw new Error(`fresnel: there is no model '${model}'; one of ${Object.keys(functions).join(', ')}`);
}

/// GLSL that defines the functions of these models, once however often it is included.
export function chunk(...models) {
    models.forEach(known);
    return guarded('FRESNEL_TYPES', types) +
        models.map((model) => guarded(`FRESNEL_${model.toUpperCase()}`, functions[model])).join('');
}

/// Adds a chunk for each model to three's own, so that a ShaderMaterial may say `#include <fresnel_schlick>`, and
/// `#include <fresnel_geometry>`.
export function registerChunks() {
    for (const model of Object.keys(functions)) ShaderChunk[`fresnel_${model}`] = chunk(model);
    ShaderChunk.fresnel_geometry = guarded('FRESNEL_TYPES', types) + guarded('FRESNEL_GEOMETRY', geometry);
}

// ---- three's own materials ----------------------------------------------------------------------------------------------

const triple = (value) => (value.isVector3 ? value
    : value.isColor ? new Vector3(value.r, value.g, value.b)
    : Array.isArray(value) ? new Vector3(...value) : new Vector3(value, value, value));

// The arguments of a call: what is given becomes a uniform, f0 and f90 that are not given are the material's own.
function argumentsOf(model, values, uniforms) {
    const own = { n_i: '1.0', f0: 'f0', f90: 'vec3(f90)' };
    const unknown = Object.keys(values).find((name) => !parameters[model].includes(name));
    if (unknown) throw new Error(`fresnel: ${model} has no parameter '${unknown}'; it takes ${parameters[model].join(', ')}`);
    return parameters[model].map((name) => {
        if (values[name] === undefined && own[name]) return own[name];
        if (values[name] === undefined) throw new Error(`fresnel: ${model} needs the parameter '${name}'`);
        uniforms[`fresnel_${name}`] = { value: name === 'n_i' ? values[name] : triple(values[name]) };
        return `fresnel_${name}`;
    });
}

function declarations(uniforms) {
    return Object.keys(uniforms).map((name) => `uniform ${name === 'fresnel_n_i' ? 'float' : 'vec3'} ${name};\n`).join('');
}

// Replaces text that must be there: three's chunks change from version to version.
function replaced(text, from, to) {
    if (!text.includes(from)) throw new Error(`fresnel: this version of three.js has no '${from}' where it was expected`);
    return text.replaceAll(from, to);
}

// three's chunk of physical lighting with another Fresnel term, but for the clear coat, which stands before BRDF_GGX.
function lightingChunk(definition) {
    const whole = ShaderChunk.lights_physical_pars_fragment, at = whole.indexOf('vec3 BRDF_GGX( ');
    if (at < 0) throw new Error('fresnel: this version of three.js has no BRDF_GGX where it was expected');
    return whole.slice(0, at) + definition + replaced(whole.slice(at), 'F_Schlick(', 'fresnel_term(');
}

// What the environment reflects was multiplied by three's approximation, averaged over the roughness; it is scaled by the
// ratio of the two terms at the mirror's angle.
const environmentCode = `
    {
        float fresnel_cos = saturate(dot(geometryNormal, geometryViewDir));
        reflectedLight.indirectSpecular *= fresnel_term(material.specularColorBlended, material.specularF90, fresnel_cos) /
            max(F_Schlick(material.specularColorBlended, material.specularF90, fresnel_cos), vec3(1e-4));
    }
`;

// Of each material the term that it has now, and all uniforms that its programs may know.
const terms = new WeakMap();

// Hooks behind those that a material has, once, however often its term changes.
function hook(material) {
    const state = { uniforms: {} }, before = material.onBeforeCompile, key = material.customProgramCacheKey;
    material.onBeforeCompile = (shader, renderer) => {
        before.call(material, shader, renderer);
        Object.assign(shader.uniforms, state.uniforms);
        let text = replaced(shader.fragmentShader, '#include <lights_physical_pars_fragment>', lightingChunk(state.definition));
        if (state.environment)
            text = replaced(text, '#include <lights_fragment_end>', `#include <lights_fragment_end>\n${environmentCode}`);
        shader.fragmentShader = text;
    };
    material.customProgramCacheKey = () => `${key.call(material)} ${before} fresnel ${state.call} ${state.environment}`;
    terms.set(material, state);
    return state;
}

// The same object for a uniform of the same name: a program that is drawn with again has the one that it was made with.
function kept(all, uniforms) {
    for (const [name, { value }] of Object.entries(uniforms)) {
        uniforms[name] = all[name] ??= uniforms[name];
        uniforms[name].value = value;
    }
    return uniforms;
}

/// Gives a MeshStandardMaterial or MeshPhysicalMaterial the Fresnel term of a model, for lights and for the environment.
///
/// values       the model's parameters: a number, a Color, a Vector3 or [r, g, b], linear. f0 and f90 that are not given
///              are the material's own, n_i is 1. `values` may be an entry of `metals` for the model 'f82'.
/// environment  false leaves what the environment reflects to three's own approximation
/// returns      the uniforms, {fresnel_f0: {value}, ...}, to be changed while the material is in use
///
/// A second call gives the material another term. A clear coat keeps its own term. Throws an Error for an unknown model, and a parameter that is unknown or missing; while
/// compiling, where three's own text is not as expected.
export function setFresnel(material, model, values = {}, { environment = true } = {}) {
    known(model);
    const uniforms = {}, call = `${model}(${[...argumentsOf(model, values, uniforms), 'cos_i'].join(', ')})`;
    const scalar = parameters[model].every((name) => name === 'n_i');
    const definition = `${declarations(uniforms)}${chunk(model)}
vec3 fresnel_term(vec3 f0, float f90, float cos_i) {
    return ${scalar ? `vec3(${call})` : call};
}

`;
    const state = terms.get(material) ?? hook(material);
    Object.assign(state, { definition, call, environment });
    material.needsUpdate = true;
    return kept(state.uniforms, uniforms);
}

// ---- a rim of light -----------------------------------------------------------------------------------------------------

/// An unlit material: a colour, and a rim by bias_scale_power. Its uniforms: base, rim, bias, scale, power.
export function rimMaterial({ base = 0x101018, rim = 0xffe0a0, bias = 0, scale = 1, power = 5 } = {}) {
    return new ShaderMaterial({
        uniforms: { base: { value: new Color(base) }, rim: { value: new Color(rim) }, bias: { value: bias },
                    scale: { value: scale }, power: { value: power } },
        vertexShader: `
varying vec3 vNormal, vView;
void main() {
    vec4 position4 = modelViewMatrix * vec4(position, 1.0);
    vNormal = normalMatrix * normal;
    vView = -position4.xyz;
    gl_Position = projectionMatrix * position4;
}`,
        fragmentShader: `
${chunk('bias_scale_power')}
uniform vec3 base, rim;
uniform float bias, scale, power;
varying vec3 vNormal, vView;
void main() {
    float F = bias_scale_power(bias, scale, power, normalize(vNormal), normalize(vView));
    gl_FragColor = vec4(mix(base, rim, F), 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
}`,
    });
}
)";

/// Before the functions of fresnel-tsl.js.
inline constexpr std::string_view threejs_tsl_code =
    R"(// A function in both languages: which one is called is known when a material is built for a backend. A name ends in Rgb
// where parameters are vec3, in Dir where two directions stand in place of cos_i.
function native(wgsl, glsl, needs) {
    const inWgsl = wgslFn(wgsl, needs.map((f) => f.inWgsl)), inGlsl = glslFn(glsl, needs.map((f) => f.inGlsl));
    const node = Fn((args, builder) => (builder.renderer.backend.isWebGPUBackend ? inWgsl : inGlsl)(...args));
    return Object.assign((...args) => node(...args), { inWgsl, inGlsl });
}
)";

inline constexpr std::string_view threejs_readme = R"(# Fresnel for three.js, version {}

Every Fresnel model of `fresnel`, exact, approximate and artistic: GLSL for `WebGLRenderer` in `fresnel.js`, nodes (TSL) for
`WebGPURenderer` in `fresnel-tsl.js`, on its WebGPU backend and on WebGL 2. Checked with three.js r187.

## Install

Copy this folder to `node_modules/fresnel-three`, or `npm install ./threejs`. `example.html` and
`example-tsl.html` run from there, on any server that serves `node_modules`.

## WebGLRenderer

    import {{ metals, setFresnel }} from 'fresnel-three';

    const gold = new MeshStandardMaterial({{ metalness: 1, roughness: 0.2 }});
    setFresnel(gold, 'f82', metals.gold);

    const glass = new MeshPhysicalMaterial({{ color: 0x000000, roughness: 0 }});
    setFresnel(glass, 'dielectric', {{ n_t: 1.5 }});

`setFresnel` replaces the Fresnel term of a standard or physical material, for lights and for the environment. Models of `f0`
take the material's own colour where you give none: `setFresnel(material, 'powers_4_8')`. It returns the uniforms.
A second call gives the material another term; hooks of your own (`onBeforeCompile`) that it has before the first one are kept.

In shaders of your own, `chunk('schlick', 'conductor')` is their GLSL; after `registerChunks()` they may say
`#include <fresnel_schlick>`. `rimMaterial()` is an unlit rim of light.

## WebGPURenderer

    import {{ normalView, positionViewDirection, mix }} from 'three/tsl';
    import {{ biasScalePowerDir, dielectricDir }} from 'fresnel-three/tsl';

    material.colorNode = mix(base, rim, biasScalePowerDir(0, 1, 5, normalView, positionViewDirection));

Nodes have no overloads, so a name says what a function takes: `schlick` one number and the cosine, `schlickRgb` three channels
that share the angle, `schlickDir` and `schlickRgbDir` two directions in place of the cosine. Directions are unit vectors and
point away from the surface, as `normalView` and `positionViewDirection` do.

## Limits

Colours are linear: three's `Color` converts hexadecimal values, arrays are taken as they are. The environment's share is that
of three's own split sum, scaled by the ratio of both terms at the mirror's angle: exact for a smooth surface. A clear coat keeps
three's term. `setFresnel` changes text of three's chunks and throws an Error where a version has it otherwise.
)";

inline constexpr std::string_view threejs_example = R"(<!doctype html>
<meta charset="utf-8">
<title>Fresnel in three.js</title>
<style>body { margin: 0; background: #101014 } canvas { display: block }</style>
<!-- Served from node_modules/fresnel-three, with three.js beside it. -->
<script type="importmap">{ "imports": { "three": "../three/build/three.module.js", "fresnel-three": "./fresnel.js",
    "three/addons/": "../three/examples/jsm/" } }</script>
<script type="module">
import * as THREE from 'three';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
import { metals, rimMaterial, setFresnel } from 'fresnel-three';

const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
document.body.append(renderer.domElement);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(12, 1, 0.1, 100);
camera.position.z = 15;
scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
const light = new THREE.DirectionalLight(0xffffff, 2);
light.position.set(1, 2, 2);
scene.add(light);

const gold = new THREE.MeshStandardMaterial({ metalness: 1, roughness: 0.2 });
setFresnel(gold, 'f82', metals.gold);
const glass = new THREE.MeshPhysicalMaterial({ color: 0x050510, roughness: 0.05 });
setFresnel(glass, 'dielectric', { n_t: 1.5 });
const chromium = new THREE.MeshStandardMaterial({ metalness: 1, roughness: 0.3 });
setFresnel(chromium, 'f82', metals.chromium);
const materials = [gold, glass, chromium, rimMaterial()];
materials.forEach((material, i) => {
    const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 64, 48), material);
    ball.position.x = 2.2 * (i - 1.5);
    scene.add(ball);
});

function draw() {
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
    renderer.setSize(innerWidth, innerHeight);
    renderer.render(scene, camera);
}
addEventListener('resize', draw);
draw();
window.drawn = true;
</script>
)";

inline constexpr std::string_view threejs_tsl_example = R"(<!doctype html>
<meta charset="utf-8">
<title>Fresnel nodes in three.js</title>
<style>body { margin: 0; background: #101014 } canvas { display: block }</style>
<!-- Served from node_modules/fresnel-three, with three.js beside it; ?webgl for the WebGL 2 backend. -->
<script type="importmap">{ "imports": { "three": "../three/build/three.module.js",
    "three/webgpu": "../three/build/three.webgpu.js", "three/tsl": "../three/build/three.tsl.js",
    "fresnel-three/tsl": "./fresnel-tsl.js" } }</script>
<script type="module">
import * as THREE from 'three/webgpu';
import { color, float, mix, normalView, positionViewDirection, uniform, vec3 } from 'three/tsl';
import { biasScalePowerDir, dielectricDir, f82RgbDir, metals } from 'fresnel-three/tsl';

const renderer = new THREE.WebGPURenderer({ antialias: true, forceWebGL: location.search === '?webgl' });
await renderer.init();
document.body.append(renderer.domElement);
const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(12, 1, 0.1, 100);
scene.background = new THREE.Color(0x101014);
camera.position.z = 15;
const light = new THREE.DirectionalLight(0xffffff, 2);
light.position.set(1, 2, 2);
scene.add(light);

// a rim of light over an unlit colour; its power can be changed while it is drawn
const power = uniform(3);
const rim = new THREE.MeshBasicNodeMaterial();
rim.colorNode = mix(color(0x101018), color(0xffe0a0), biasScalePowerDir(0, 1, power, normalView, positionViewDirection));

// copper before a white world: its colours at normal incidence and at cos 1/7
const copper = new THREE.MeshBasicNodeMaterial(), { f0, f82 } = metals.copper;
copper.colorNode = f82RgbDir(vec3(...f0), vec3(...f82), normalView, positionViewDirection);

// a lit base under a coat of index 1.5 that mirrors a blue sky
const coated = new THREE.MeshStandardNodeMaterial({ color: 0x802010, roughness: 0.8 });
coated.emissiveNode = color(0x80b0ff).mul(dielectricDir(float(1), float(1.5), normalView, positionViewDirection));

[copper, coated, rim].forEach((material, i) => {
    const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 64, 48), material);
    ball.position.x = 2.2 * (i - 1);
    scene.add(ball);
});

function resize() {
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
    renderer.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();
renderer.setAnimationLoop(() => {
    renderer.render(scene, camera);
    window.drawn = true;
});
</script>
)";

} // namespace fresnel::emit
