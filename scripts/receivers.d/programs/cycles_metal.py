"""What Cycles' own Metallic BSDF reflects of a white world at roughness 0, at every angle.

    python cycles_metal.py OUT.csv f82 R,G,B R,G,B          base colour, edge tint
    python cycles_metal.py OUT.csv conductor R,G,B R,G,B    index, extinction

Writes the cosine and the three channels of each facet of a sphere that the camera sees.
"""
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

from cycles_scene import oiio, scene

SIZE = 512


def sphere(s):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=192, ring_count=96, radius=0.49 * SIZE, location=(SIZE / 2, SIZE / 2, 0))
    thing = bpy.context.object
    s.camera.location.z = SIZE
    s.camera.data.clip_end = 2 * SIZE
    world = bpy.data.worlds.new("white")
    s.world = world
    background = next(n for n in world.node_tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    return thing.data


def metal(mesh, kind, first, second):
    m = bpy.data.materials.new("metal")
    nodes, links = m.node_tree.nodes, m.node_tree.links
    nodes.clear()
    bsdf = nodes.new("ShaderNodeBsdfMetallic")
    bsdf.fresnel_type = {"f82": "F82", "conductor": "PHYSICAL_CONDUCTOR"}[kind]
    bsdf.inputs["Roughness"].default_value = 0
    if kind == "f82":
        bsdf.inputs["Base Color"].default_value = (*first, 1)
        bsdf.inputs["Edge Tint"].default_value = (*second, 1)
    else:
        bsdf.inputs["IOR"].default_value = first
        bsdf.inputs["Extinction"].default_value = second
    links.new(bsdf.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    mesh.materials.append(m)


def subimages(path):
    image = oiio.ImageInput.open(str(path))
    found, part = {}, 0
    while image.seek_subimage(part, 0):
        spec = image.spec()
        pixels = np.asarray(image.read_image(part, 0, 0, spec.nchannels, oiio.FLOAT)).reshape(-1, spec.nchannels)
        for c, name in enumerate(spec.channelnames):
            found[".".join(name.split(".")[-2:])] = pixels[:, c]
        part += 1
    image.close()
    return found


def main(out, kind, first, second):
    s = scene(SIZE)
    s.cycles.max_bounces = 4
    s.view_layers[0].use_pass_normal = True
    s.render.image_settings.media_type = "MULTI_LAYER_IMAGE"
    s.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    metal(sphere(s), kind, *[tuple(float(x) for x in text.split(",")) for text in (first, second)])
    with tempfile.TemporaryDirectory() as work:
        s.render.filepath = str(Path(work) / "out.exr")
        bpy.ops.render.render(write_still=True)
        found = subimages(s.render.filepath)
    cos_i = found["Normal.Z"]
    seen = (cos_i > 0) & (cos_i <= 1)
    columns = [cos_i] + [found[f"Combined.{c}"] for c in "RGB"]
    table = np.unique(np.stack(columns, axis=-1)[seen], axis=0)
    np.savetxt(out, table, delimiter=",", header="cos_i,r,g,b", comments="", fmt="%.9g")


if __name__ == "__main__":
    main(*sys.argv[1:])
