"""oslc.py FILE...   in the Python that has bpy: compiles each FILE and prints, last, a list of what oslc said against it."""
import json
import os
import sys
import tempfile

if __name__ == "__main__":
    import bpy  # it brings _cycles
    import _cycles
    # has stdosl.h; otherwise it is looked for beside Python
    addon = os.path.join(bpy.utils.resource_path("LOCAL"), "scripts", "addons_core", "cycles")
    _cycles.init(addon, tempfile.gettempdir(), True)

    def said(file):
        """oslc writes to the standard output and error themselves, not to Python's."""
        with tempfile.TemporaryFile() as log:
            kept = os.dup(1), os.dup(2)
            os.dup2(log.fileno(), 1), os.dup2(log.fileno(), 2)
            try:
                good = _cycles.osl_compile(file, file + ".oso")
            finally:
                os.dup2(kept[0], 1), os.dup2(kept[1], 2)
                os.close(kept[0]), os.close(kept[1])
            log.seek(0)
            text = log.read().decode(errors="replace").strip()
        warned = "warning" in text.lower()
        return "" if good and not warned else text or "refused"

    print(json.dumps([said(file) for file in sys.argv[1:]]))
