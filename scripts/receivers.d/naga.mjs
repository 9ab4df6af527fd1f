// node naga.mjs MODULES FILE...   prints a list: for each file of WGSL what naga says against it, or nothing, and then
// FILE.spv holds the SPIR-V. This build of naga checks no types of its own accord; spirv-val over FILE.spv does.
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, ...files] = process.argv.slice(2);
const folder = path.join(modules, 'wgsl-wasm-transpiler-bundler');
const glue = path.join(folder, 'wgsl_wasm_transpiler_bg.js');
const naga = await import(pathToFileURL(glue));
const { instance } = await WebAssembly.instantiate(fs.readFileSync(path.join(folder, 'wgsl_wasm_transpiler_bg.wasm')),
    { './wgsl_wasm_transpiler_bg.js': naga });
naga.__wbg_set_wasm(instance.exports);
instance.exports.__wbindgen_start();

function said(file) {
    try {
        const spirv = naga.compileShader(fs.readFileSync(file, 'utf8'), 'spirv');
        fs.writeFileSync(`${file}.spv`, Buffer.from(spirv, 'base64'));
        return '';
    } catch (error) {
        return String(error);
    }
}

console.log(JSON.stringify(files.map(said)));
