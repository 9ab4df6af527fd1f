"""Compiles OSL files with the oslc of Blender: the last line that is printed is JSON, a message for each.

    python oslc.py FILE...
"""
import json
import os
import sys
import tempfile

import bpy  # noqa: F401
import _cycles


def compiled(file):
    """What oslc says of a file that it refuses: it prints, so its output is caught."""
    with tempfile.TemporaryFile("w+") as said:
        kept = os.dup(1), os.dup(2)
        os.dup2(said.fileno(), 1), os.dup2(said.fileno(), 2)
        try:
            accepted = _cycles.osl_compile(file, file + ".oso")
        finally:
            os.dup2(kept[0], 1), os.dup2(kept[1], 2)
            os.close(kept[0]), os.close(kept[1])
        said.seek(0)
        return "" if accepted else said.read().strip() or "refused"


if __name__ == "__main__":
    print(json.dumps([compiled(file) for file in sys.argv[1:]]))
