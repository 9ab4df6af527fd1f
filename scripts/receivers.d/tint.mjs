// node tint.mjs MODULES FILE...   prints a list: for each file of WGSL what Tint says against it, or nothing
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, ...files] = process.argv.slice(2);
const { create, globals } = await import(pathToFileURL(path.join(modules, 'webgpu/index.js')));
Object.assign(globalThis, globals);
// kept alive: all that comes from it dies with it
globalThis.gpu = create(['backend=null']);
const adapter = await globalThis.gpu.requestAdapter();
const device = await adapter.requestDevice();
device.onuncapturederror = () => {};

async function said(file) {
    device.pushErrorScope('validation');
    const module = device.createShaderModule({ code: fs.readFileSync(file, 'utf8') });
    const { messages } = await module.getCompilationInfo();
    await device.popErrorScope();
    return messages.map((m) => `${m.lineNum}:${m.linePos} ${m.type}: ${m.message}`).join('\n');
}

const all = [];
for (const file of files) all.push(await said(file));
console.log(JSON.stringify(all));
process.exit(0);
