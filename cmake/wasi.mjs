// node wasi.mjs PROGRAM ARGUMENT...: runs a WebAssembly program that expects WASI, with the environment of this one.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const args = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args, env: process.env });
const { instance } = await WebAssembly.instantiate(await readFile(args[0]),
                                                   { wasi_snapshot_preview1: wasi.wasiImport });
process.exitCode = wasi.start(instance);
