// In the page: materials of the three.js pack rendered by three.js into float targets.

async function floats(renderer, target, width, height) {
    if (renderer.isWebGLRenderer) {
        const values = new Float32Array(4 * width * height);
        renderer.readRenderTargetPixels(target, 0, 0, width, height, values);
        return values;
    }
    return renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
}

// ---- WebGLRenderer -------------------------------------------------------------------------------------------------------

/// The values of GLSL expressions of `c` and `d`, a cosine and a direction that has it with (0, 0, 1), at 256 cosines.
export async function glslValues(models, calls) {
    const THREE = await import('three'), { chunk } = await import('fresnel-three');
    const renderer = new THREE.WebGLRenderer();
    const target = new THREE.WebGLRenderTarget(256, calls.length, { type: THREE.FloatType });
    const material = new THREE.ShaderMaterial({
        vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
        fragmentShader: `${chunk(...models)}
void main() {
    int row = int(gl_FragCoord.y);
    float c = gl_FragCoord.x / 256.0, F = -1.0;
    vec3 d = vec3(sqrt(1.0 - c * c), 0.0, c);
${calls.map((call, i) => `    if (row == ${i}) F = ${call};`).join('\n')}
    gl_FragColor = vec4(F);
}` });
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
    renderer.setRenderTarget(target);
    renderer.render(scene, new THREE.Camera());
    const values = await floats(renderer, target, 256, calls.length);
    renderer.dispose();
    return Array.from(values.filter((_, i) => i % 4 === 0));
}

// A sphere of a metal with that model's Fresnel term, under a light from several sides one after another, or in a white
// environment: all pixels of all pictures; `used` is a material that is kept. A light's angle of incidence is half of its angle with the view.
async function sphere(THREE, setFresnel, model, values, lit, used) {
    const size = 48, scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 1, 0.1, 100);
    camera.position.z = 4.2;
    const material = used ?? new THREE.MeshStandardMaterial({ metalness: 1, roughness: lit ? 0.9 : 0, color: 0xffffff });
    setFresnel(material, model, values);
    scene.add(new THREE.Mesh(new THREE.SphereGeometry(1, 96, 64), material));
    const light = new THREE.DirectionalLight(0xffffff, 3);
    if (lit) scene.add(light);
    else scene.environment = white(THREE);
    const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType }), all = [];
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    for (const degrees of lit ? [5, 60, 100, 140] : [0]) {
        const angle = degrees * Math.PI / 180;
        light.position.set(Math.sin(angle), 0, Math.cos(angle));
        renderer.clear();
        renderer.render(scene, camera);
        all.push(...await floats(renderer, target, size, size));
    }
    target.dispose();
    if (!used) material.dispose();
    return all;
}

let renderer, environment;
function white(THREE) {
    const room = new THREE.Scene();
    room.background = new THREE.Color(1, 1, 1);
    return environment ??= new THREE.PMREMGenerator(renderer).fromScene(room).texture;
}

/// What a patched MeshStandardMaterial reflects, as a multiple of what it reflects where the model is the constant 1:
/// [{cos, F}], red, green and blue of F, the cosine by the model one_minus_cos. Whether lit by a light or an environment.
export async function patched(jobs, lit) {
    const THREE = await import('three'), { setFresnel } = await import('fresnel-three');
    renderer ??= new THREE.WebGLRenderer();
    const one = await sphere(THREE, setFresnel, 'constant', { f0: 1 }, lit);
    const angle = await sphere(THREE, setFresnel, 'one_minus_cos', {}, lit), all = [];
    const brightest = one.reduce((most, x, i) => (i % 4 === 0 ? Math.max(most, x) : most), 0);
    for (const { model, values } of jobs) {
        const image = await sphere(THREE, setFresnel, model, values, lit), points = [];
        for (let i = 0; i < one.length; i += 4)
            if (one[i + 3] > 0.5 && one[i] > 1e-3 * brightest)
                points.push({ cos: 1 - angle[i] / one[i], F: [0, 1, 2].map((c) => image[i + c] / one[i + c]) });
        all.push(points);
    }
    return all;
}

/// A material whose term is changed while it is drawn, to a model and back, reflects what one that was never changed does: the
/// largest difference of their pixels after each call, for each of the values of the jobs.
export async function changed(jobs) {
    const THREE = await import('three'), { setFresnel } = await import('fresnel-three');
    renderer ??= new THREE.WebGLRenderer();
    const material = new THREE.MeshStandardMaterial({ metalness: 1, roughness: 0.9, color: 0xffffff }), all = [];
    let hooked = 0;
    material.onBeforeCompile = () => { ++hooked; };
    for (const { model, values } of jobs) {
        const once = await sphere(THREE, setFresnel, model, values, true);
        const again = await sphere(THREE, setFresnel, model, values, true, material);
        all.push(again.reduce((most, x, i) => Math.max(most, Math.abs(x - once[i])), 0));
    }
    material.dispose();
    return { differences: all, hooked };
}

/// What is said against a wrong use of setFresnel, and against a chunk that is not GLSL.
export async function refusals() {
    const THREE = await import('three'), { setFresnel, functions } = await import('fresnel-three');
    const said = {}, material = () => new THREE.MeshStandardMaterial();
    const attempt = (name, f) => { try { f(); } catch (error) { said[name] = error.message; } };
    attempt('model', () => setFresnel(material(), 'slick'));
    attempt('parameter', () => setFresnel(material(), 'schlick', { f1: 0.04 }));
    attempt('missing', () => setFresnel(material(), 'dielectric'));
    attempt('version', () => {
        const text = THREE.ShaderChunk.lights_physical_pars_fragment, one = material();
        THREE.ShaderChunk.lights_physical_pars_fragment = 'void nothing() {}';
        setFresnel(one, 'schlick');
        try { one.onBeforeCompile({ uniforms: {}, fragmentShader: '#include <lights_physical_pars_fragment>' }); }
        finally { THREE.ShaderChunk.lights_physical_pars_fragment = text; }
    });
    const good = functions.photometric;
    functions.photometric = good.replace('return', 'return undefined_name +');
    renderer.debug.onShaderError = (gl, program, vertex, fragment) => { said.compiler = gl.getShaderInfoLog(fragment); };
    await patched([{ model: 'photometric', values: {} }], true);
    functions.photometric = good;
    return said;
}

// ---- WebGPURenderer ------------------------------------------------------------------------------------------------------

/// The values of nodes at 256 cosines: for each of up to four jobs {name, values}, a function of fresnel-tsl.js with
/// numbers or triples before the cosine or the two directions. `channel` 1 is the second of three.
export async function nodeValues(groups, forceWebGL) {
    const THREE = await import('three/webgpu'), tsl = await import('three/tsl'), fresnel = await import('fresnel-three/tsl');
    const renderer = new THREE.WebGPURenderer({ forceWebGL });
    await renderer.init();
    const backend = renderer.backend.isWebGPUBackend ? 'WebGPU' : 'WebGL 2', all = [];
    const target = new THREE.RenderTarget(256, 1, { type: THREE.FloatType });
    for (const jobs of groups) {
        const c = tsl.screenCoordinate.x.div(256);
        const d = tsl.vec3(tsl.sqrt(tsl.float(1).sub(c.mul(c))), 0, c);
        const nodes = jobs.map(({ name, values, directions, rgb }) => {
            const given = values.map((v) => (Array.isArray(v) ? tsl.vec3(...v) : tsl.float(v)));
            const F = fresnel[name](...given, ...(directions ? [tsl.vec3(0, 0, 1), d] : [c]));
            return rgb ? F.y : F;
        });
        while (nodes.length < 4) nodes.push(tsl.float(0));
        const material = new THREE.NodeMaterial();
        material.fragmentNode = tsl.vec4(...nodes);
        const quad = new THREE.QuadMesh(material);
        renderer.setRenderTarget(target);
        quad.render(renderer);
        all.push(Array.from(await floats(renderer, target, 256, 1)));
        material.dispose();
    }
    renderer.dispose();
    return { backend, values: all };
}
