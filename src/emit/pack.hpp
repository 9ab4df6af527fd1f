#pragma once

#include <string>
#include <vector>

namespace fresnel::emit {

/// A generated file: its place under shaders/, and all that it holds.
struct pack_file {
    std::string path, text;
};

/// One library file for each language: glsl/fresnel.glsl and so on.
std::vector<pack_file> language_packs();

/// three.js: a package with GLSL for WebGLRenderer and nodes for WebGPURenderer.
std::vector<pack_file> threejs_pack();

/// Godot 4: an addon's folder.
std::vector<pack_file> godot_pack();
/// unity/: a package with the HLSL library and materials for the built-in pipeline and URP.
std::vector<pack_file> unity_pack();

/// unreal/: the HLSL library for the Custom node, and how it is used there.
std::vector<pack_file> unreal_pack();
/// A MaterialX data library: a node for every model, in GLSL and OSL.
std::vector<pack_file> materialx_pack();

/// OSL shaders for the Script node of Blender's Cycles, one for every model.
std::vector<pack_file> blender_pack();

/// Every file of shaders/, in order of path. Each engine's pack is made in a file of its own under src/emit/packs.
std::vector<pack_file> all_packs();

/// Writes every file under a folder, each aside and then renamed, and removes nothing. Throws failure.
void write_packs(const std::string& folder);

/// The files under a folder that are not what write_packs writes: "glsl/fresnel.glsl differs", "... is missing",
/// "... is not generated". Empty where all is right. Throws bad_input where there is no such folder.
std::vector<std::string> check_packs(const std::string& folder);

} // namespace fresnel::emit
