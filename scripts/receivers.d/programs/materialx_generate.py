"""Loads a data library into MaterialX beside its own, and generates shaders that use each of its nodes.

    python materialx_generate.py each|all PACK OUT [DOCUMENT...]

Writes OUT/TARGET/NAME.STAGE for every target of MaterialX: for all node definitions of the library at once, with `each`
for every one of them too, and for each material DOCUMENT. The last line that is printed is JSON: how many definitions there are, the names
of what was generated, and what MaterialX says is wrong.
"""
import json
import sys
from pathlib import Path

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenMsl, PyMaterialXGenOsl, PyMaterialXGenShader, PyMaterialXGenSlang

GENERATORS = {
    "glsl": PyMaterialXGenGlsl.GlslShaderGenerator, "essl": PyMaterialXGenGlsl.EsslShaderGenerator,
    "vulkan": PyMaterialXGenGlsl.VkShaderGenerator, "wgsl": PyMaterialXGenGlsl.WgslShaderGenerator,
    "osl": PyMaterialXGenOsl.OslShaderGenerator, "msl": PyMaterialXGenMsl.MslShaderGenerator,
    "slang": PyMaterialXGenSlang.SlangShaderGenerator}
EXTENSIONS = {"vertex": "vert", "pixel": "frag"}


def library(pack):
    """The standard library and ours, and our definitions."""
    path = mx.getDefaultDataSearchPath()
    path.append(mx.FilePath(str(pack)))
    all_nodes = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), path, all_nodes)
    before = {d.getName() for d in all_nodes.getNodeDefs()}
    mx.loadLibraries([mx.FilePath("libraries/fresnel")], path, all_nodes)
    return all_nodes, path, [d for d in all_nodes.getNodeDefs() if d.getName() not in before]


def outputs(document, node, definition):
    """One colour made of all outputs of a node."""
    name = node.getName()
    if definition.getType() == "color3":
        return node
    total = None
    for output in definition.getActiveOutputs():
        scaled = document.addNode("multiply", f"{name}_{output.getName()}", "float")
        link = scaled.addInput("in1", "float")
        link.setNodeName(name)
        if definition.getType() == "multioutput":
            link.setOutputString(output.getName())
        scaled.setInputValue("in2", 0.5)
        if total is not None:
            add = document.addNode("add", f"{name}_{output.getName()}_sum", "float")
            add.addInput("in1", "float").setNodeName(total.getName())
            add.addInput("in2", "float").setNodeName(scaled.getName())
            scaled = add
        total = scaled
    colour = document.addNode("convert", f"{name}_colour", "color3")
    colour.addInput("in", "float").setNodeName(total.getName())
    return colour


def surface(document, colours):
    """A material that shows the sum of these nodes."""
    total = colours[0]
    for other in colours[1:]:
        add = document.addNode("add", f"{other.getName()}_total", "color3")
        add.addInput("in1", "color3").setNodeName(total.getName())
        add.addInput("in2", "color3").setNodeName(other.getName())
        total = add
    shader = document.addNode("surface_unlit", "shader", "surfaceshader")
    shader.addInput("emission_color", "color3").setNodeName(total.getName())
    material = document.addNode("surfacematerial", "material", "material")
    material.addInput("surfaceshader", "surfaceshader").setNodeName("shader")


def using(all_nodes, definitions):
    document = mx.createDocument()
    document.setDataLibrary(all_nodes)
    colours = []
    for definition in definitions:
        node = document.addNodeInstance(definition, definition.getName().removeprefix("ND_"))
        for given in definition.getActiveInputs():
            if not given.hasDefaultGeomPropString():
                node.addInput(given.getName(), given.getType()).setValueString(given.getValueString())
        colours.append(outputs(document, node, definition))
    surface(document, colours)
    return document


def complaints(document, name):
    """What is wrong with a document, and nodes that no definition answers to, which MaterialX calls valid."""
    valid, said = document.validate()
    found = [] if valid else [f"{name}: {said.strip()}"]
    return found + [f"{name}: no definition of {n.getCategory()} '{n.getName()}'"
                    for n in document.getNodes() if n.getNodeDef() is None]


def generate(document, name, path, out):
    said = []
    for target, kind in GENERATORS.items():
        generator = kind.create()
        context = PyMaterialXGenShader.GenContext(generator)
        context.registerSourceCodeSearchPath(path)
        (out / target).mkdir(parents=True, exist_ok=True)
        try:
            shader = generator.generate(name, document.getMaterialNodes()[0], context)
        except Exception as problem:  # the bindings raise their own
            said.append(f"{name}: {target}: {problem}")
            continue
        for stage, extension in EXTENSIONS.items():
            if stage == "pixel" or target != "osl":
                (out / target / f"{name}.{extension}").write_text(shader.getSourceCode(stage))
    return said


def main(which, pack, out, *documents):
    all_nodes, path, definitions = library(pack)
    said = complaints(all_nodes, "the library")
    for definition in definitions:
        for target in ("genglsl", "essl", "genmsl", "genslang", "genosl"):
            if definition.getImplementation(target) is None:
                said.append(f"{definition.getName()}: has no implementation for {target}")
    made = {d.getName(): using(all_nodes, [d]) for d in definitions} if which == "each" else {}
    made["all"] = using(all_nodes, definitions)
    for file in documents:
        document = mx.createDocument()
        mx.readFromXmlFile(document, file)
        document.setDataLibrary(all_nodes)
        made[Path(file).stem] = document
    names = []
    for name, document in made.items():
        wrong = complaints(document, name) or generate(document, name, path, Path(out))
        said += wrong
        names += [] if wrong else [name]
    print(json.dumps({"definitions": len(definitions), "names": names, "said": said}))


if __name__ == "__main__":
    main(*sys.argv[1:])
