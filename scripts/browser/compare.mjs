// What is claimed of a function that runs somewhere, the comparison of its values with the model's, and the table.
import fs from 'node:fs';
import path from 'node:path';

/// Where a text runs, and the language of it.
export const receivers = { webgl2: 'essl', webgpu: 'wgsl', lavapipe: 'wgsl' };

const bounds = {
    moved: 1e-6,          // compilers join constants, move them inside products, multiply by the reciprocal of one
    transcendental: 2e-6, // exp2, log2, log and pow, in units of the largest factor before a power
};

// Mesa moves a constant inside a product unless the text says `precise`, which WGSL cannot.
const moved = ['gulbrandsen', 'f82_tint'];

/// The floats of a file.
export function floats(file) {
    return new Float32Array(new Uint8Array(fs.readFileSync(file)).buffer);
}

// Column of each parameter that matters for the error of a power: exponents, and factors before it.
function columnsOf(one) {
    const columns = { exponents: [], factors: [] };
    let at = 0;
    for (const { name, width } of one.arguments)
        for (let i = 0; i < width; ++i, ++at) {
            if (name === 'power' || name === 'alpha') columns.exponents.push(at);
            if (name === 'scale' || name === 'a') columns.factors.push(at);
        }
    return columns;
}

// The largest difference that is allowed, and why. Without `precise` Mesa also takes (a + b) - a for b, which is what the
// compensated sums of conductor_precise are made of: nothing is claimed of it there.
function claimOf(one, receiver) {
    if (one.transcendental) return { allowed: bounds.transcendental, why: 'of exp2, log2, log or pow' };
    if (one.kind === 'fixed') return { allowed: bounds.moved, why: 'with every parameter a constant' };
    if (receiver === 'lavapipe' && one.name === 'conductor_precise')
        return { allowed: Infinity, why: 'of compensated sums, which need `precise`' };
    if (receiver === 'lavapipe' && moved.includes(one.name))
        return { allowed: bounds.moved, why: 'with a constant inside a product' };
    return { allowed: 0, why: 'of + - * / sqrt' };
}

const counts = () => ({ inputs: 0, differing: 0, largest: 0 });

/// Rows by what their inputs are: `compared`, about which something is claimed; `elsewhere`, with exponents outside
/// [1, 10]; `infinite` and `nan`; `undefined`, where the model's value is NaN of finite inputs. Their largest
/// difference is in units of the largest factor before a power, at least 1.
export function compare(folder, one, receiver) {
    const read = (name) => floats(path.join(folder, name));
    const inputs = read(one.inputs), expected = read(one.expected), found = read(`${one.id}.${receiver}.out.f32`);
    if (found.length !== expected.length) throw new Error(`${one.id} on ${receiver}: ${found.length} values`);
    const { allowed, why } = claimOf(one, receiver);
    const columns = one.transcendental ? columnsOf(one) : { exponents: [], factors: [] };
    const all = { compared: counts(), elsewhere: counts(), infinite: counts(), nan: counts(),
                  undefined: counts() };
    for (let row = 0, i = 0; row < one.rows; ++row) {
        const first = row * one.columns;
        let sum = 0; // NaN where an input is NaN, infinite where one is infinite
        for (let k = first; k < first + one.columns; ++k) sum += Math.abs(inputs[k]);
        let kind = Number.isNaN(sum) ? 'nan' : sum === Infinity ? 'infinite' : 'compared', unit = 1;
        for (const k of columns.exponents)
            if (kind === 'compared' && !(inputs[first + k] >= 1 && inputs[first + k] <= 10)) kind = 'elsewhere';
        for (const k of columns.factors) unit = Math.max(unit, Math.abs(inputs[first + k]));
        let differs = false, most = 0, isNan = false;
        for (const end = i + one.results; i < end; ++i) {
            isNan ||= Number.isNaN(expected[i]);
            if (Object.is(expected[i], found[i])) continue;
            differs = true;
            const distance = Math.abs(expected[i] - found[i]) / unit;
            most = Math.max(most, Number.isNaN(distance) ? Infinity : distance);
        }
        if (isNan && kind !== 'nan' && kind !== 'infinite') kind = 'undefined';
        ++all[kind].inputs;
        if (!differs) continue;
        ++all[kind].differing;
        all[kind].largest = Math.max(all[kind].largest, most);
    }
    const { inputs: rows, differing, largest } = all.compared;
    return { id: one.id, name: one.name, kind: one.kind, receiver, allowed, why, ...all,
             passed: rows > 0 && (allowed ? largest <= allowed : differing === 0) };
}

// ---- the table -----------------------------------------------------------------------------------------------------------

const short = (x) => x.toExponential(1);
const sum = (results, kind, what) => results.reduce((n, r) => n + r[kind][what], 0);
const most = (results, kind) => Math.max(...results.map((r) => r[kind].largest));

/// Prints a line for each function, then what holds on each receiver.
export function print(results) {
    console.log('\nfunction                          receiver  inputs  differing  largest  allowed');
    for (const r of results)
        console.log(r.id.padEnd(34) + r.receiver.padEnd(9) + String(r.compared.inputs).padStart(7) +
            String(r.compared.differing).padStart(11) + short(r.compared.largest).padStart(9) +
            short(r.allowed).padStart(9) + (r.passed ? '' : '  FAILS'));
    for (const receiver of new Set(results.map((r) => r.receiver)))
        summarize(receiver, results.filter((r) => r.receiver === receiver));
    console.log('\nAn input that is infinite or NaN is counted apart: what min, max, clamp, comparisons and powers make of it ' +
                'is left open by both languages.\nInputs in whose evaluation a number is subnormal are left out.');
}

function summarize(receiver, results) {
    console.log('');
    for (const why of new Set(results.map((r) => r.why))) {
        const some = results.filter((r) => r.why === why), allowed = some[0].allowed;
        console.log(`${receiver}: ${some.length} functions ${why}: ${sum(some, 'compared', 'differing')} of ` +
            `${sum(some, 'compared', 'inputs')} inputs differ, by at most ${short(most(some, 'compared'))} ` +
            `(${allowed === Infinity ? 'nothing claimed' : `allowed ${allowed}`})`);
    }
    console.log(`${receiver}: apart from these, ${sum(results, 'elsewhere', 'inputs')} inputs of a power with exponents ` +
        `outside [1, 10]: ${sum(results, 'elsewhere', 'differing')} differ, by at most ${short(most(results, 'elsewhere'))}; ` +
        `${sum(results, 'infinite', 'inputs')} with an infinity: ${sum(results, 'infinite', 'differing')} differ; ` +
        `${sum(results, 'nan', 'inputs')} with a NaN: ${sum(results, 'nan', 'differing')} differ; ` +
        `${sum(results, 'undefined', 'inputs')} finite ones of which the model itself makes a NaN: ` +
        `${sum(results, 'undefined', 'differing')} differ`);
}
