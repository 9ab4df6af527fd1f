"""lavapipe.py FOLDER: runs the WGSL of the cases in FOLDER/cases.json on Mesa's software Vulkan device, through wgpu and
naga, and writes FOLDER/ID.lavapipe.out.f32. Prints the device's name, then what was said against a text, a line each.
Exit code 77, with the reason, where there is no such device."""
import json
import os
import sys
from pathlib import Path

DRIVER = os.environ.setdefault("VK_ICD_FILENAMES", "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json")
import wgpu  # noqa: E402

MEMBERS = {1: [""], 3: [".x", ".y", ".z"], 4: [".R_s", ".R_p", ".T_s", ".T_p"]}


def program(text, case):
    columns, results = case["columns"], case["results"]
    stores = "\n".join(f"    harness_out[row * {results}u + {k}u] = harness_r{member};"
                       for k, member in enumerate(MEMBERS[results]))
    return f"""{text}
@group(0) @binding(0) var<storage, read> harness_in: array<f32>;
@group(0) @binding(1) var<storage, read_write> harness_out: array<f32>;
@compute @workgroup_size(64) fn harness_main(@builtin(global_invocation_id) id: vec3u) {{
    let row = id.x;
    if (row >= {case["rows"]}u) {{ return; }}
    var x: array<f32, {columns}>;
    for (var k = 0u; k < {columns}u; k++) {{ x[k] = harness_in[row * {columns}u + k]; }}
    let harness_r = {case["call"]["wgsl"]};
{stores}
}}"""


def evaluate(device, text, case, inputs):
    size = 4 * case["rows"] * case["results"]
    module = device.create_shader_module(code=program(text, case))
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "harness_main"})
    source = device.create_buffer_with_data(data=inputs, usage=wgpu.BufferUsage.STORAGE)
    target = device.create_buffer(size=size, usage=wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_SRC)
    group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=[
        {"binding": i, "resource": {"buffer": buffer, "offset": 0, "size": buffer.size}}
        for i, buffer in enumerate((source, target))])
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    work.set_bind_group(0, group)
    work.dispatch_workgroups((case["rows"] + 63) // 64)
    work.end()
    device.queue.submit([encoder.finish()])
    return device.queue.read_buffer(target)


def main(folder):
    if not Path(DRIVER).exists():
        print(f"no {DRIVER}; scripts/setup installs mesa-vulkan-drivers")
        sys.exit(77)
    adapter = wgpu.gpu.request_adapter_sync(power_preference="low-power")
    print(f"{adapter.info['device']}, {adapter.info['description']}")
    device = adapter.request_device_sync()
    for case in json.loads((folder / "cases.json").read_text()):
        try:
            values = evaluate(device, (folder / case["text"]["wgsl"]).read_text(), case,
                              (folder / case["inputs"]).read_bytes())
            (folder / f"{case['id']}.lavapipe.out.f32").write_bytes(values)
        except wgpu.GPUError as error:
            print(f"{case['id']}: {' '.join(str(error).split())}")


main(Path(sys.argv[1]))
