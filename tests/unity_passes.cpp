// unity_passes DIR
// Writes the Unity pack under DIR, and beside each shader the program of each of its passes, ready to be compiled:
//   DIR/unity/Runtime/Shaders/BuiltIn/Lit.ForwardBase.hlsl
// with a line for each on standard output: its path, the vertex and the fragment function, separated by blanks.
#include "shader_lab.hpp"

#include "emit/pack.hpp"
#include "error.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: unity_passes DIR\n";
        return 2;
    }
    const std::filesystem::path root = arguments[1];
    for (const fresnel::emit::pack_file& file : fresnel::emit::unity_pack()) {
        const std::filesystem::path path = root / file.path;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << file.text;
        if (path.extension() != ".shader") continue;
        const fresnel::test::shader_lab shader(file.text);
        for (const std::string& complaint : shader.complaints) {
            std::cerr << "unity_passes: " << file.path << ": " << complaint << "\n";
            return 1;
        }
        for (const fresnel::test::shader_pass& pass : shader.passes) {
            const std::filesystem::path program =
                path.parent_path() / (path.stem().string() + "." + pass.name + ".hlsl");
            std::ofstream(program, std::ios::binary) << pass.text;
            std::cout << program.string() << " " << pass.vertex << " " << pass.fragment << "\n";
        }
    }
    return 0;
}
