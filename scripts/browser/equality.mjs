// node equality.mjs FRESNEL FOLDER [MODEL...]
//
// Runs every printed function in headless Chromium, GLSL ES on WebGL 2 and WGSL on WebGPU, and its WGSL on Mesa's
// lavapipe, over inputs that the command FRESNEL writes with the model's values (`fresnel shader --verify --dump FOLDER`),
// and compares bits. Functions of + - * / and sqrt must give the very bits for every finite input, others stay within
// the bounds of compare.mjs. Then texts with a fault must be seen to differ, or be refused with a message. FOLDER/browser.json holds the table; FOLDER/ID.RECEIVER.out.f32 the values, which
// `fresnel shader --verify --compare FOLDER` reads too.
// Exit code 0, 1 where a claim does not hold, 77 (and `skipped: reason`) where there is no browser.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

import { launch, pip, root, serve } from './chromium.mjs';
import { compare, floats, print } from './compare.mjs';

const languages = { essl: 'webgl2', wgsl: 'webgpu' }; // what the browser runs, and where
const [fresnel, folder, ...models] = process.argv.slice(2);
if (!folder) {
    console.error('usage: equality.mjs FRESNEL FOLDER [MODEL...]');
    process.exit(2);
}

function command(...options) {
    const done = spawnSync(fresnel, ['shader', '--verify', ...options], { encoding: 'utf8', maxBuffer: 1 << 26 });
    if (done.error) throw done.error;
    return done;
}

function dump() {
    fs.rmSync(folder, { recursive: true, force: true });
    const done = command('--dump', folder, ...models);
    if (done.status !== 0) throw new Error(done.stderr);
    return JSON.parse(fs.readFileSync(path.join(folder, 'cases.json'), 'utf8'));
}

async function open() {
    const browser = await launch();
    const server = await serve({ '/': path.join(root, 'scripts/browser'), '/data/': folder },
        (at, bytes) => fs.writeFileSync(path.join(folder, path.basename(at)), bytes));
    const page = await browser.newPage();
    await page.goto(`${server.address}/evaluate.html`);
    return {
        run: (jobs, from, to) => page.evaluate(async (given) => (await import('./evaluate.js')).run(...given),
            [jobs, `/data/${from}`, Object.fromEntries(Object.entries(to).map(([l, f]) => [l, `/out/${f}`]))]),
        name: (language) => page.evaluate(async (l) => (await import('./evaluate.js')).name(l), language),
        version: browser.version(),
        close: async () => { await browser.close(); server.close(); },
    };
}

const job = (one, language, text) => ({ text: text ?? fs.readFileSync(path.join(folder, one.text[language]), 'utf8'),
                                        call: one.call[language], columns: one.columns, results: one.results,
                                        rows: one.rows });

// ---- every function ------------------------------------------------------------------------------------------------------

async function runAll(chromium, cases) {
    const failures = [];
    for (const one of cases) {
        const of = (make) => Object.fromEntries(Object.keys(languages).map((language) => [language, make(language)]));
        const said = await chromium.run(of((language) => job(one, language)), one.inputs,
                                        of((language) => `${one.id}.${languages[language]}.out.f32`));
        for (const language of Object.keys(languages))
            if (said[language]) failures.push(`${one.id} in ${language}: ${said[language]}`);
    }
    return failures;
}

// The WGSL on lavapipe. Returns the device's name and what was said against texts; a name alone, null, where it cannot run.
function runLavapipe() {
    const python = pip('wgpu');
    const done = python.skipped ? null
        : spawnSync(python.path, [path.join(root, 'scripts/browser/lavapipe.py'), folder], { encoding: 'utf8' });
    if (!done || done.status === 77) {
        console.log(`skipped: lavapipe: ${python.skipped ?? done.stdout.trim()}`);
        return { name: null, failures: [] };
    }
    const [name, ...failures] = done.stdout.trim().split('\n');
    if (done.status !== 0) failures.push(`ended with ${done.status}: ${done.stderr.trim()}`);
    return { name, failures: failures.map((said) => `lavapipe: ${said}`) };
}

// ---- the comparison and the compilers see faults -------------------------------------------------------------------------

// schlick with a factor too few; with a factor that rounds differently; with a name that is not defined.
const faults = {
    'a factor missing': (text) => text.replace('(x2 * x2 * x)', '(x2 * x2)'),
    'a product in another order': (text) => text.replace('(x2 * x2 * x)', '(x2 * (x2 * x))'),
    'an unknown name': (text) => text.replace('(x2 * x2 * x)', '(x2 * x2 * undefined_name)'),
};

function differs(one, file) {
    const [expected, found] = [one.expected, file].map((name) => floats(path.join(folder, name)));
    return expected.some((value, i) => value !== found[i] && !Number.isNaN(value));
}

async function seesFault(chromium, one, language, fault) {
    const text = fs.readFileSync(path.join(folder, one.text[language]), 'utf8'), broken = faults[fault](text);
    if (broken === text) return `the text of ${one.id} has changed: no place for a fault`;
    const file = `fault.${languages[language]}.f32`;
    const said = (await chromium.run({ [language]: job(one, language, broken) }, one.inputs, { [language]: file }))[language];
    if (fault === 'an unknown name') {
        console.log(`${languages[language]} refuses ${fault}: ${said.split('\n')[0]}`);
        return said.includes('undefined_name') ? '' : `${language}: ${fault} is not refused`;
    }
    if (said) return said;
    return differs(one, file) ? '' : `${language}: ${fault} is not seen`;
}

async function runFaults(chromium, cases) {
    const one = cases.find((c) => c.id === 'schlick');
    if (!one) return [];
    const failures = [];
    for (const language of Object.keys(languages))
        for (const fault of Object.keys(faults)) {
            const said = await seesFault(chromium, one, language, fault);
            if (said) failures.push(said);
        }
    return failures;
}

// --------------------------------------------------------------------------------------------------------------------------

const chromium = await open();
try {
    const began = Date.now(), cases = dump(), dumped = Date.now();
    const devices = {};
    for (const language of Object.keys(languages)) devices[languages[language]] = await chromium.name(language);
    const failures = [...await runAll(chromium, cases), ...await runFaults(chromium, cases)];
    const lavapipe = runLavapipe();
    if (lavapipe.name) devices.lavapipe = lavapipe.name;
    failures.push(...lavapipe.failures);
    console.log(`Chromium ${chromium.version}; ${Object.entries(devices).map(([k, v]) => `${k}: ${v}`).join('; ')}`);

    const ran = Date.now(), ready = (one, receiver) => fs.existsSync(path.join(folder, `${one.id}.${receiver}.out.f32`));
    const pairs = cases.flatMap((one) => Object.keys(devices).map((receiver) => [one, receiver]));
    const results = pairs.filter(([one, receiver]) => ready(one, receiver))
        .map(([one, receiver]) => compare(folder, one, receiver));
    print(results);
    failures.push(...pairs.filter(([one, receiver]) => !ready(one, receiver))
        .map(([one, receiver]) => `${one.id} on ${receiver}: gave nothing`));
    failures.push(...results.filter((r) => !r.passed).map((r) => `${r.id} on ${r.receiver}: ${r.compared.differing} of ` +
        `${r.compared.inputs} inputs differ, by at most ${r.compared.largest}; allowed ${r.allowed}`));
    fs.writeFileSync(path.join(folder, 'browser.json'),
        JSON.stringify({ chromium: chromium.version, devices, results, failures }, null, 1) + '\n');
    console.log(`${((dumped - began) / 1000).toFixed(1)} s to write, ${((ran - dumped) / 1000).toFixed(1)} s to run, ` +
        `${((Date.now() - ran) / 1000).toFixed(1)} s to compare`);
    for (const failure of failures) console.error(`equality: ${failure}`);
    process.exitCode = failures.length ? 1 : 0;
} finally {
    await chromium.close();
}
