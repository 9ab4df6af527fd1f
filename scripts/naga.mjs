#!/usr/bin/env node
// fresnel-naga IN OUT                checks WGSL (IN.wgsl) or SPIR-V (IN.spv) and writes it as the other, by OUT's ending
// fresnel-naga --pairs IN OUT [IN OUT]...
//                                    several, in the time that one takes to start
// fresnel-naga --bulk-validate IN... only checks
// naga, the compiler behind wgpu, as WebAssembly; the command line is that of the crate naga-cli. scripts/setup installs it.
import fs from 'node:fs';
import process from 'node:process';
import { NagaError, nagaVersion, parseSpirv, parseWgsl, validate, writeSpirv, writeWgsl } from 'naga-wasm';

function translate(from, to) {
    const module = from.endsWith('.spv') ? parseSpirv(fs.readFileSync(from)) : parseWgsl(fs.readFileSync(from, 'utf8'));
    const info = validate(module);
    if (to) fs.writeFileSync(to, to.endsWith('.spv') ? writeSpirv(module, info) : writeWgsl(module, info));
    info.free();
    module.free();
}

function isAccepted(from, to) {
    try {
        translate(from, to);
        return true;
    } catch (error) {
        console.error(`${from}\n${error instanceof NagaError ? error.formatted.trim() : `error: ${error.message}`}`);
        return false;
    }
}

const [first, ...others] = process.argv.slice(2);
if (first === '--version') {
    console.log(nagaVersion);
} else if (first === '--bulk-validate' && others.length > 0) {
    const accepted = others.filter((file) => isAccepted(file));
    process.exitCode = accepted.length === others.length ? 0 : 1;
} else if (first === '--pairs' && others.length > 0 && others.length % 2 === 0) {
    const accepted = others.filter((file, i) => i % 2 === 0 && isAccepted(file, others[i + 1]));
    process.exitCode = accepted.length === others.length / 2 ? 0 : 1;
} else if (first && !first.startsWith('-') && others.length === 1) {
    process.exitCode = isAccepted(first, others[0]) ? 0 : 1;
} else {
    console.error('usage: fresnel-naga IN OUT | --pairs IN OUT [IN OUT]... | --bulk-validate IN... | --version');
    process.exitCode = 2;
}
