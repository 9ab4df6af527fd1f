// node threejs.mjs FRESNEL FOLDER
//
// The three.js pack in three.js itself, in headless Chromium: every function of fresnel.js in a ShaderMaterial and every node
// of fresnel-tsl.js, on WebGPU and on WebGL 2, at 256 cosines; setFresnel with every model on a sphere under a light, and
// under an environment. All values must be the model's. What is broken or misused must be refused. FOLDER/*.png are
// the pack's examples.
// Exit code 0, 1 where something is wrong, 77 (and `skipped: reason`) where there is no browser.
import fs from 'node:fs';
import path from 'node:path';

import { launch, npm, root, serve, version } from './chromium.mjs';
import { argumentsOf, callOf, expected, functionsOf, run } from './functions.mjs';

// What rendering adds: a ratio of two products of light, and the division that gives the angle back.
const allowed = { function: 2e-6, sphere: 2e-5 };
const cosines = Array.from({ length: 256 }, (_, i) => (i + 0.5) / 256);
const [fresnel, folder] = process.argv.slice(2);
if (!folder) {
    console.error('usage: threejs.mjs FRESNEL FOLDER');
    process.exit(2);
}

const page = `<!doctype html><meta charset="utf-8"><title>fresnel</title><script type="importmap">{ "imports": {
    "three": "/node_modules/three/build/three.module.js", "three/webgpu": "/node_modules/three/build/three.webgpu.js",
    "three/tsl": "/node_modules/three/build/three.tsl.js", "fresnel-three": "/node_modules/fresnel-three/fresnel.js",
    "fresnel-three/tsl": "/node_modules/fresnel-three/fresnel-tsl.js" } }</script>`;

const failures = [];
let worst = {};

function judge(what, name, cos, found, value, limit) {
    const difference = Math.abs(found - value);
    worst[what] = Math.max(worst[what] ?? 0, Number.isNaN(difference) ? Infinity : difference);
    if (!(difference <= limit) && failures.length < 40)
        failures.push(`${what}: ${name} at ${cos}: ${found}, expected ${value}`);
}

function report(what, count) {
    console.log(`threejs: ${what}: ${count}: by at most ${worst[what]?.toExponential(1)}`);
}

// ---- every function ------------------------------------------------------------------------------------------------------

async function checkGlsl(tab, models, functions) {
    const overloaded = functions.map((one) => ({ ...one, name: one.suffix === '_boundary' ? one.name : one.model }));
    const calls = overloaded.map((one) => callOf(one, 'vec3', 'c', 'd'));
    const values = await tab.evaluate(([m, c]) => window.check.glslValues(m, c), [models.map((m) => m.name), calls]);
    functions.forEach((one, row) => expected(fresnel, one, cosines).forEach((value, i) =>
        judge('WebGLRenderer, chunks', calls[row], cosines[i], values[256 * row + i], value, allowed.function)));
    report('WebGLRenderer, chunks', `${functions.length} functions`);
}

const camel = (name) => name.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

async function checkNodes(tab, models, functions, forceWebGL) {
    const plain = functions.filter((one) => one.suffix !== '_boundary');
    const groups = models.map((model) => plain.filter((one) => one.model === model.name));
    const jobs = groups.map((group) => group.map((one) => ({ name: camel(one.name), values: argumentsOf(one),
        directions: one.suffix.endsWith('_dir'), rgb: one.suffix.startsWith('_rgb') })));
    const { backend, values } = await tab.evaluate(([j, w]) => window.check.nodeValues(j, w), [jobs, forceWebGL]);
    const what = `WebGPURenderer on ${backend}, nodes`;
    if (backend !== (forceWebGL ? 'WebGL 2' : 'WebGPU')) failures.push(`${what}: is another backend than asked for`);
    groups.forEach((group, g) => group.forEach((one, k) => expected(fresnel, one, cosines).forEach((value, i) =>
        judge(what, camel(one.name), cosines[i], values[g][4 * i + k], value, allowed.function))));
    report(what, `${plain.length} functions`);
}

// ---- setFresnel ----------------------------------------------------------------------------------------------------------

async function checkPatched(tab, functions, lit) {
    const what = `setFresnel, ${lit ? 'a light' : 'an environment'}`;
    const ones = functions.filter((one) => one.suffix === '_rgb' || (one.suffix === '' && one.parameters.length === 0));
    const jobs = ones.map((one) => ({ model: one.model, values: Object.fromEntries(
        argumentsOf(one).map((value, i) => [one.parameters[i].name, value])) }));
    const images = await tab.evaluate(([j, l]) => window.check.patched(j, l), [jobs, lit]);
    ones.forEach((one, k) => {
        const points = images[k].filter((p) => p.cos >= 0 && p.cos <= 1).filter((_, i) => i % 5 === 0);
        const truth = expected(fresnel, one, points.map((p) => p.cos));
        points.forEach((p, i) => judge(what, one.model, p.cos, p.F[1], truth[i], allowed.sphere));
        if (points.length < 20) failures.push(`${what}: ${one.model}: ${points.length} points`);
    });
    const all = images[0].map((p) => p.cos);
    report(what, `${ones.length} models, ${images[0].length} pixels with cosines from ` +
        `${Math.min(...all).toFixed(3)} to ${Math.max(...all).toFixed(3)}`);
}

// Another model, the first one again, and other values of it.
async function checkChanged(tab) {
    const f0 = (...rgb) => ({ model: 'schlick', values: { f0: rgb } });
    const { differences, hooked } = await tab.evaluate((jobs) => window.check.changed(jobs),
        [f0(1, 0.78, 0.34), { model: 'dielectric', values: { n_t: 1.5 } }, f0(1, 0.78, 0.34), f0(0.95, 0.64, 0.54)]);
    if (!differences.every((x) => x === 0)) failures.push(`setFresnel, called again: ${differences}`);
    if (hooked < 2) failures.push(`setFresnel, called again: a hook of the material's own is called ${hooked} times`);
    console.log(`threejs: setFresnel, called again: ${differences.length} times, the same pixels`);
}

async function checkRefusals(tab) {
    const said = await tab.evaluate(() => window.check.refusals());
    for (const [what, part] of Object.entries({ model: "no model 'slick'", parameter: "no parameter 'f1'",
        missing: "needs the parameter 'n_t'", version: 'this version of three.js', compiler: 'undefined_name' }))
        if (said[what]?.includes(part)) console.log(`threejs: refused: ${said[what].trim().split('\n')[0]}`);
        else failures.push(`refusals: ${what}: ${said[what]}`);
}

// The comparison sees a wrong value: a node of another model in its place.
async function checkSensitivity(tab, functions) {
    const one = functions.find((f) => f.name === 'schlick');
    const { values } = await tab.evaluate((j) => window.check.nodeValues([j], true),
        [{ name: 'powers48', values: argumentsOf(one), directions: false, rgb: false }]);
    const truth = expected(fresnel, one, cosines);
    if (truth.every((value, i) => Math.abs(value - values[0][4 * i]) <= allowed.function))
        failures.push('another model is not seen to differ');
}

// --------------------------------------------------------------------------------------------------------------------------

async function main(browser, address) {
    const models = JSON.parse(run(fresnel, ['models', '--json']));
    const functions = functionsOf(run(fresnel, ['shader', '--all', '--lang', 'gdshader']), models);
    const tab = await browser.newPage();
    tab.on('pageerror', (error) => failures.push(`page: ${error.message}`));
    await tab.goto(`${address}/run/page.html`);
    await tab.evaluate(async () => { window.check = await import('/threejs_page.js'); });
    await checkGlsl(tab, models, functions);
    await checkPatched(tab, functions, true);
    await checkPatched(tab, functions, false);
    await checkChanged(tab);
    await checkRefusals(tab);
    await checkNodes(tab, models, functions, false);
    await checkNodes(tab, models, functions, true);
    await checkSensitivity(tab, functions);

    await checkExample(browser, `${address}/node_modules/fresnel-three/example.html`, 'threejs.png');
    await checkExample(browser, `${address}/node_modules/fresnel-three/example-tsl.html`, 'threejs-webgpu.png');
    await checkExample(browser, `${address}/node_modules/fresnel-three/example-tsl.html?webgl`, 'threejs-webgl.png');
}

// In the page: the share of a picture's pixels that are not dark.
async function brightShare(base64) {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(image.width, image.height).getContext('2d');
    canvas.drawImage(image, 0, 0);
    const { data } = canvas.getImageData(0, 0, image.width, image.height);
    let bright = 0;
    for (let i = 0; i < data.length; i += 4) bright += data[i] + data[i + 1] + data[i + 2] > 150;
    return bright / (data.length / 4);
}

async function checkExample(browser, address, picture) {
    const tab = await browser.newPage({ viewport: { width: 1000, height: 280 } });
    tab.on('console', (message) => {
        if (message.type() === 'error' && !message.text().includes('404')) failures.push(`${picture}: ${message.text()}`);
    });
    tab.on('pageerror', (error) => failures.push(`${picture}: ${error.message}`));
    await tab.goto(address);
    await tab.waitForFunction(() => window.drawn, null, { timeout: 60000 });
    for (let tries = 0; tries < 20; ++tries) { // until the compositor has it
        await tab.waitForTimeout(250);
        const bytes = await tab.screenshot({ path: path.join(folder, picture) });
        if (await tab.evaluate(brightShare, bytes.toString('base64')) > 0.1) break;
        if (tries === 19) failures.push(`${picture}: shows nothing`);
    }
    tab.removeAllListeners(); // a device that is lost as its page closes is no error
    await tab.close();
}

fs.rmSync(folder, { recursive: true, force: true });
fs.mkdirSync(folder, { recursive: true });
const browser = await launch();
run(fresnel, ['shader', '--write', path.join(folder, 'shaders')]);
fs.writeFileSync(path.join(folder, 'page.html'), page);
const server = await serve({ '/': path.join(root, 'scripts/browser'), '/run/': folder, '/node_modules/three/': path.join(npm('three'), 'three'),
                             '/node_modules/fresnel-three/': path.join(folder, 'shaders/threejs') });
try {
    console.log(`threejs: three.js ${version('three')}, Chromium ${browser.version()}`);
    await main(browser, server.address);
    for (const failure of failures) console.error(`threejs: ${failure}`);
    process.exitCode = failures.length ? 1 : 0;
} finally {
    await browser.close();
    server.close();
}
