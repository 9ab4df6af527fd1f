// In the page: runs emitted text over arrays of floats, GLSL ES as a fragment shader of WebGL 2, WGSL as a compute shader
// of WebGPU. A job is {text, call, columns, results, rows}: `call` is the expression that calls the function, x[k] being
// column k of a row of the inputs. What a compiler says against a text is thrown as an Error.

const members = { 1: [''], 3: ['.x', '.y', '.z'], 4: ['.R_s', '.R_p', '.T_s', '.T_p'] };

export class WebGl2 {
    #gl; #wide = 1024; #target = 512;

    constructor() {
        this.#gl = new OffscreenCanvas(1, 1).getContext('webgl2');
        if (!this.#gl) throw new Error('this browser has no WebGL 2');
        if (!this.#gl.getExtension('EXT_color_buffer_float')) throw new Error('there are no float render targets');
    }

    async name() {
        const gl = this.#gl, info = gl.getExtension('WEBGL_debug_renderer_info');
        return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    }

    #shader(kind, text) {
        const gl = this.#gl, shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
        return shader;
    }

    #program(job) {
        const gl = this.#gl, program = gl.createProgram();
        const values = members[job.results].map((m) => `harness_r${m}`);
        while (values.length < 4) values.push('0.0');
        gl.attachShader(program, this.#shader(gl.VERTEX_SHADER, `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`));
        gl.attachShader(program, this.#shader(gl.FRAGMENT_SHADER, `#version 300 es
${job.text}
uniform highp sampler2D harness_inputs;
out highp vec4 harness_out;
void main() {
    int harness_row = int(gl_FragCoord.x) + ${this.#target} * int(gl_FragCoord.y);
    float x[${job.columns}];
    for (int k = 0; k < ${job.columns}; ++k) {
        int harness_at = harness_row * ${job.columns} + k;
        x[k] = texelFetch(harness_inputs, ivec2(harness_at % ${this.#wide}, harness_at / ${this.#wide}), 0).x;
    }
    ${{ 1: 'float', 3: 'vec3', 4: 'fresnel_boundary' }[job.results]} harness_r = ${job.call};
    harness_out = vec4(${values.join(', ')});
}`));
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
        return program;
    }

    #texture(internal, format, width, height, data) {
        const gl = this.#gl, texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, gl.FLOAT, data);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return texture;
    }

    async evaluate(job, inputs) {
        const gl = this.#gl, program = this.#program(job);
        const high = Math.ceil(job.rows / this.#target), deep = Math.ceil(inputs.length / this.#wide);
        const target = this.#texture(gl.RGBA32F, gl.RGBA, this.#target, high, null);
        const frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
        const padded = new Float32Array(deep * this.#wide);
        padded.set(inputs);
        const source = this.#texture(gl.R32F, gl.RED, this.#wide, deep, padded);
        gl.viewport(0, 0, this.#target, high);
        gl.useProgram(program);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const all = new Float32Array(4 * this.#target * high);
        gl.readPixels(0, 0, this.#target, high, gl.RGBA, gl.FLOAT, all);
        const error = gl.getError();
        if (error !== gl.NO_ERROR) throw new Error(`WebGL error ${error}`);
        gl.deleteTexture(source), gl.deleteTexture(target), gl.deleteFramebuffer(frame), gl.deleteProgram(program);
        const values = new Float32Array(job.rows * job.results);
        for (let row = 0, i = 0; row < job.rows; ++row)
            for (let k = 0; k < job.results; ++k) values[i++] = all[4 * row + k];
        return values;
    }
}

export class WebGpu {
    #adapter; #device;

    static async open() {
        const made = new WebGpu();
        made.#adapter = await navigator.gpu?.requestAdapter();
        if (!made.#adapter) throw new Error('this browser has no WebGPU adapter');
        made.#device = await made.#adapter.requestDevice();
        return made;
    }

    async name() {
        const { vendor, architecture, description } = this.#adapter.info;
        return [vendor, architecture, description].filter(Boolean).join(' ');
    }

    async #pipeline(job) {
        const stores = members[job.results].map((m, k) =>
            `    harness_out[row * ${job.results}u + ${k}u] = harness_r${m};`).join('\n');
        const code = `${job.text}
@group(0) @binding(0) var<storage, read> harness_in: array<f32>;
@group(0) @binding(1) var<storage, read_write> harness_out: array<f32>;
@compute @workgroup_size(64) fn harness_main(@builtin(global_invocation_id) id: vec3u) {
    let row = id.x;
    if (row >= ${job.rows}u) { return; }
    var x: array<f32, ${job.columns}>;
    for (var k = 0u; k < ${job.columns}u; k++) { x[k] = harness_in[row * ${job.columns}u + k]; }
    let harness_r = ${job.call};
${stores}
}`;
        this.#device.pushErrorScope('validation');
        const module = this.#device.createShaderModule({ code });
        const { messages } = await module.getCompilationInfo();
        const said = messages.map((m) => `${m.lineNum}:${m.linePos} ${m.type}: ${m.message}`).join('\n');
        const pipeline = this.#device.createComputePipeline({ layout: 'auto', compute: { module } });
        const error = await this.#device.popErrorScope();
        if (error) throw new Error(said || error.message);
        return pipeline;
    }

    async evaluate(job, inputs) {
        const device = this.#device, pipeline = await this.#pipeline(job);
        const size = 4 * job.rows * job.results;
        const buffer = (bytes, usage) => device.createBuffer({ size: bytes, usage });
        const source = buffer(inputs.byteLength, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST);
        const target = buffer(size, GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC);
        const read = buffer(size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
        device.queue.writeBuffer(source, 0, inputs);
        const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: [
            { binding: 0, resource: { buffer: source } }, { binding: 1, resource: { buffer: target } }] });
        const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, group);
        pass.dispatchWorkgroups(Math.ceil(job.rows / 64));
        pass.end();
        encoder.copyBufferToBuffer(target, 0, read, 0, size);
        device.queue.submit([encoder.finish()]);
        await read.mapAsync(GPUMapMode.READ);
        const values = new Float32Array(read.getMappedRange().slice(0));
        source.destroy(), target.destroy(), read.destroy();
        return values;
    }
}

const devices = {};
const device = (language) => devices[language] ??= language === 'essl' ? Promise.resolve(new WebGl2()) : WebGpu.open();

/// The name of the device that runs that language.
export async function name(language) { return (await device(language)).name(); }

/// Runs jobs, {language: job}, over the inputs at an address, side by side, and posts their values to `to[language]`.
/// Returns for each language what was said against it.
export async function run(jobs, from, to) {
    const inputs = new Float32Array(await (await fetch(from)).arrayBuffer());
    return Promise.all(Object.entries(jobs).map(async ([language, job]) => {
        try {
            const values = await (await device(language)).evaluate(job, inputs);
            await fetch(to[language], { method: 'POST', body: values });
            return [language, ''];
        } catch (error) {
            return [language, error.message || String(error)];
        }
    })).then(Object.fromEntries);
}
