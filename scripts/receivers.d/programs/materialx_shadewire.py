"""Reads a data library of MaterialX with shadewire, which is stricter than MaterialX about definitions and graphs.

    python materialx_shadewire.py PACK

shadewire knows no source text: of a node whose graph ends in source text it says so, and that it came so far is the
check. The last line that is printed is JSON: how many nodes were read so far, and what else was said.
"""
import json
import re
import sys
from pathlib import Path

import shadewire

# The one property of the standard library's that shadewire does not define.
VIEW = '<geompropdef name="Vworld" type="vector3" geomprop="viewdirection" space="world" />'


def inside(file):
    """What a document holds."""
    return re.search(r"<materialx[^>]*>(.*)</materialx>", file.read_text(), re.S)[1]


def document(library, node, kind):
    colour = ('<convert name="colour" type="color3"><input name="in" type="float" nodename="tested" /></convert>'
              if kind == "float" else "")
    return (f'<?xml version="1.0"?><materialx version="1.39">{library}<{node} name="tested" type="{kind}" />{colour}'
            f'<surface_unlit name="shader" type="surfaceshader"><input name="emission_color" type="color3" '
            f'nodename="{"colour" if colour else "tested"}" /></surface_unlit>'
            '<surfacematerial name="m" type="material"><input name="surfaceshader" type="surfaceshader" '
            'nodename="shader" /></surfacematerial></materialx>')


def main(pack):
    folder = Path(pack) / "libraries/fresnel"
    library = VIEW + inside(folder / "fresnel_defs.mtlx") + inside(folder / "fresnel_ng.mtlx")
    nodes = re.findall(r'<nodegraph name="NG_(\w+)_(float|color3)"', library)
    read, said = 0, []
    for node, kind in nodes:
        try:
            shadewire.mtlx.to_ir(document(library, node, kind), material="m")
            said.append(f"{node}: was read without an implementation")
        except shadewire.ShadewireError as error:
            if re.search(r"no implementation for ND_fresnel_\w+$", str(error)):
                read += 1
            else:
                said.append(f"{node}: {error}")
    print(json.dumps({"read": read, "said": said}))


if __name__ == "__main__":
    main(*sys.argv[1:])
