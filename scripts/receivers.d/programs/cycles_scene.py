"""A Blender scene in which every pixel is one evaluation of an OSL shader.

The inputs are attributes of the faces of a grid, one face a pixel, which Cycles hands to the shader as they are: no
interpolation, no colour management. The result is what the face emits. For a Python that has bpy.
"""
import glob
import sys

import bpy
import numpy as np

sys.path += glob.glob(bpy.utils.system_resource("PYTHON") + "/lib/python3*/site-packages")

import OpenImageIO as oiio  # noqa: E402
import cycles.osl  # noqa: E402


def scene(size):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    s = bpy.context.scene
    s.render.engine = "CYCLES"
    s.cycles.device = "CPU"
    s.cycles.shading_system = True
    s.cycles.samples = 1
    s.cycles.use_adaptive_sampling = s.cycles.use_denoising = False
    s.cycles.max_bounces = 0
    s.cycles.pixel_filter_type = "BOX"
    s.cycles.filter_width = 0.01
    s.view_settings.view_transform = "Raw"
    s.render.resolution_x = s.render.resolution_y = size
    s.render.resolution_percentage = 100
    s.render.image_settings.file_format = "OPEN_EXR"
    s.render.image_settings.color_depth = "32"
    s.render.image_settings.exr_codec = "NONE"
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = size
    camera.location = (size / 2, size / 2, 1)
    s.collection.objects.link(camera)
    s.camera = camera
    return s


def grid(s, size):
    """A square face for each pixel."""
    x, y = np.meshgrid(np.arange(size + 1), np.arange(size + 1))
    points = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3).astype(np.float32)
    row, column = np.divmod(np.arange(size * size), size)
    corner = row * (size + 1) + column
    faces = np.stack([corner, corner + 1, corner + size + 2, corner + size + 1], axis=-1)
    mesh = bpy.data.meshes.new("grid")
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", points.ravel())
    mesh.loops.add(faces.size)
    mesh.loops.foreach_set("vertex_index", faces.ravel().astype(np.int32))
    mesh.polygons.add(len(faces))
    mesh.polygons.foreach_set("loop_start", np.arange(0, faces.size, 4, dtype=np.int32))
    mesh.update()
    thing = bpy.data.objects.new("grid", mesh)
    s.collection.objects.link(thing)
    return mesh


def set_attribute(mesh, name, values, size):
    """One number for each pixel, in the order of an image, as the faces' attribute of that name."""
    padded = np.ones(size * size, dtype=np.float32)
    padded[:len(values)] = values
    # the first row of an image is at the top, the first row of faces at the bottom
    attribute = mesh.attributes.new(name, "FLOAT", "FACE")
    attribute.data.foreach_set("value", padded.reshape(size, size)[::-1].ravel())


class NotCompiled(Exception):
    """What Blender says of a text that does not compile."""


def emitting(mesh):
    """A new material of the mesh. Returns its nodes, its links and the colour that it emits."""
    m = bpy.data.materials.new("harness")
    nodes, links = m.node_tree.nodes, m.node_tree.links
    nodes.clear()
    emission = nodes.new("ShaderNodeEmission")
    links.new(emission.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    mesh.materials.append(m)
    return nodes, links, emission.inputs["Color"]


def script(nodes, path=None, text=None):
    """A Script node with the shader of a file, or of a text inside the .blend file."""
    node = nodes.new("ShaderNodeScript")
    if text is None:
        node.mode, node.filepath = "EXTERNAL", str(path)
    else:
        block = bpy.data.texts.new("shader")
        block.write(text)
        node.mode, node.script = "INTERNAL", block
    said = []
    if not cycles.osl.update_script_node(node, lambda kind, message: said.append(message)) or not node.outputs:
        raise NotCompiled(" ".join(said) or "the shader has no output")
    return node


def attribute(nodes, name):
    """The output of a face's number: Cycles has only those attributes that a node of its own asks for."""
    node = nodes.new("ShaderNodeAttribute")
    node.attribute_name = name
    return node.outputs["Fac"]


def render(s, path):
    """Renders into a file of float32. Returns its pixels: rows of red, green and blue."""
    s.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image(0, 0, 0, 3, oiio.FLOAT)
    image.close()
    return np.asarray(pixels).reshape(-1, 3)
