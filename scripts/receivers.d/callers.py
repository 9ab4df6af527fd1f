"""The calls of every function of a text, as statements that add what they return to harness_sum."""
from receiver import functions

# What stands for a table, by the type of the argument; in HLSL, global names.
TABLES = {"string": '"table.exr"', "Texture2D": "harness_table", "SamplerState": "harness_filtering",
          "sampler2D": "harness_table"}
TABLE_OF_HLSL = "Texture2D harness_table;\nSamplerState harness_filtering;\n"


# the types of two numbers, whose components are x and y
pairs = ("vec2", "vec2f", "float2", "fresnel_float2")


def call(language, function, one, three, direction):
    """A call with these texts as arguments: a number, an RGB value, a direction; two numbers are another call's."""
    # elsewhere directions and RGB values are of one type
    is_direction = {"osl": "vector"}.get(language)
    pair = f"{function.name[:function.name.rfind(':') + 1]}two_sum({one}, {one})"
    texts = []
    for kind in function.arguments:
        texts.append(one if kind in ("float", "f32") else pair if kind in pairs
                     else direction if kind == is_direction else TABLES.get(kind, three))
    return f"{function.name}({', '.join(texts)})"


def statements(language, text, one="harness_one", three="harness_three", direction="harness_direction"):
    declare = {"wgsl": "let {name} = {value};"}.get(language, "{type} {name} = {value};")
    component = "{name}[0]" if language == "osl" else "{name}.x"
    lines = []
    for i, function in enumerate(functions(language, text)):
        name = f"harness_{i}"
        lines.append("    " + declare.format(type=function.result, name=name,
                                             value=call(language, function, one, three, direction)))
        value = (name if function.result in ("float", "f32")
                 else f"{name}.R_s + {name}.R_p + {name}.T_s + {name}.T_p" if function.result.endswith("fresnel_boundary")
                 else f"{name}.x" if function.result.endswith("fresnel_float2") else component.format(name=name))
        lines.append(f"    harness_sum {'= harness_sum +' if language == 'wgsl' else '+='} {value};")
    return "\n".join(lines)
