// The functions of an emitted library, calls of them, and the values that the model in C++ gives there.
import { spawnSync } from 'node:child_process';

export function run(fresnel, options, input) {
    const done = spawnSync(fresnel, options, { encoding: 'utf8', input, maxBuffer: 1 << 26 });
    if (done.error) throw done.error;
    if (done.status !== 0) throw new Error(`fresnel ${options.join(' ')}: ${done.stderr.trim()}`);
    return done.stdout;
}

const suffixes = ['_rgb_dir', '_dir', '_rgb', '_boundary', ''];

/// Every function of a model in a text of a language without overloads: {name, model, suffix, parameters}, the
/// parameters of the registry.
export function functionsOf(text, models) {
    const names = [...text.matchAll(/^(?:fn |\w+ )(\w+)\([^{};]*\{$/gm)].map((found) => found[1]);
    return names.flatMap((name) => {
        for (const suffix of suffixes) {
            const model = models.find((m) => name === m.name + suffix);
            if (model) return [{ name, suffix, model: model.name, parameters: model.parameters }];
        }
        return [];
    });
}

// A value of a parameter, that of the second channel where there are three.
function valueOf(parameter, channel) {
    const usual = parameter.name === 'k_t' || parameter.name === 'k' ? 2.4 : parameter.default;
    const value = parameter.name === 'n_i' ? 1 : [1, 0.9, 0.8][channel] * usual;
    return Math.fround(Math.min(Math.max(value, parameter.min), parameter.max));
}

const written = (x) => (Number.isInteger(x) ? x.toFixed(1) : String(x));

/// The arguments of a call before the angle: numbers, or triples.
export function argumentsOf(one) {
    const rgb = one.suffix.startsWith('_rgb');
    return one.parameters.map((p) => (rgb && p.name !== 'n_i' ? [0, 1, 2].map((c) => valueOf(p, c)) : valueOf(p, 0)));
}

/// The expression that calls a function, a number: of three channels the second, of a boundary the mean of both
/// reflectances. `cosine` and `direction` are texts, the latter a direction that has this cosine with (0, 0, 1).
export function callOf(one, vec3, cosine, direction) {
    const rgb = one.suffix.startsWith('_rgb');
    const values = argumentsOf(one).map((value) => (Array.isArray(value)
        ? `${vec3}(${value.map(written).join(', ')})` : written(value)));
    values.push(...(one.suffix.endsWith('_dir') ? [`${vec3}(0.0, 0.0, 1.0)`, direction] : [cosine]));
    const call = `${one.name}(${values.join(', ')})`;
    if (one.suffix === '_boundary') return `(${call}.R_s + ${call}.R_p) / 2.0`;
    return rgb ? `${call}.y` : call;
}

/// What the model in C++ gives at those cosines, in float.
export function expected(fresnel, one, cosines) {
    const channel = one.suffix.startsWith('_rgb') ? 1 : 0;
    const fixed = one.parameters.map((p) => valueOf(p, channel));
    const rows = cosines.map((c) => [...fixed, c].join(','));
    const csv = [[...one.parameters.map((p) => p.name), 'cos_i'].join(','), ...rows].join('\n') + '\n';
    const lines = run(fresnel, ['eval', one.model, '--csv', '-', '--type', 'float'], csv).trim().split('\n');
    const column = lines[0].split(',').indexOf('R');
    return lines.slice(1).map((line) => Number(line.split(',')[column]));
}
