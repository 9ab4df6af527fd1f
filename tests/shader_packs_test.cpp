#include "emit/pack.hpp"

#include <fresnel/models.hpp>

#include <gtest/gtest.h>

#include <map>
#include <regex>

using namespace fresnel;

namespace {

std::map<std::string, std::string> texts(const std::vector<emit::pack_file>& files) {
    std::map<std::string, std::string> by_path;
    for (const emit::pack_file& file : files)
        EXPECT_TRUE(by_path.emplace(file.path, file.text).second) << file.path << " is there twice";
    return by_path;
}

std::vector<std::smatch> matches(const std::string& text, const std::string& pattern) {
    const std::regex compiled(pattern);
    return {std::sregex_iterator(text.begin(), text.end(), compiled), std::sregex_iterator()};
}

/// Names of a node's inputs and outputs, in the order of its definition.
std::string ports_of(const std::string& definitions, const std::string& definition) {
    const std::size_t from = definitions.find("name=\"" + definition + "\"");
    if (from == std::string::npos) return definition + " is not defined";
    const std::string text = definitions.substr(from, definitions.find("</nodedef>", from) - from);
    std::string names;
    for (const std::smatch& m : matches(text, "<(?:in|out)put name=\"(\\w+)\""))
        names += m[1].str() + " ";
    return names;
}

/// Names of a function's arguments; a result that is alone is a node's output out.
std::string arguments_of(const std::string& source, const std::string& function) {
    const std::size_t from = source.find("void " + function + "(");
    if (from == std::string::npos) return function + " is not in the source";
    const std::string text = source.substr(from, source.find(')', from) + 1 - from);
    std::string names;
    for (const std::smatch& m : matches(text, "(\\w+)[,)]"))
        names += (m[1] == "result" ? "out" : m[1].str()) + " ";
    return names;
}

const std::string root = "materialx/libraries/fresnel/";

void expect_every_implementation(const std::string& target) {
    const auto files = texts(emit::materialx_pack());
    const std::string& definitions = files.at(root + "fresnel_defs.mtlx");
    const std::string& list = files.at(root + target + "/fresnel_" + target + "_impl.mtlx");
    const std::regex line("nodedef=\"(\\w+)\" file=\"([\\w.]+)\" function=\"(\\w+)\"");
    int count = 0;
    for (std::sregex_iterator m(list.begin(), list.end(), line), end; m != end; ++m, ++count) {
        const auto file = files.find(root + target + "/" + (*m)[2].str());
        ASSERT_NE(file, files.end()) << (*m)[2];
        std::string wanted = ports_of(definitions, (*m)[1]);
        // normal is a word of OSL
        wanted =
            std::regex_replace(wanted, std::regex("\\bnormal\\b"), target == "genosl" ? "normal_" : "normal");
        EXPECT_EQ(arguments_of(file->second, (*m)[3]), wanted) << (*m)[3];
    }
    EXPECT_GE(count, 60);
}

} // namespace

TEST(shader_packs, materialx_glsl_functions_take_what_the_nodes_define) {
    expect_every_implementation("genglsl");
}

TEST(shader_packs, materialx_osl_functions_take_what_the_nodes_define) {
    expect_every_implementation("genosl");
}

TEST(shader_packs, materialx_has_every_model_for_numbers_and_colours) {
    const auto files = texts(emit::materialx_pack());
    const std::string& definitions = files.at(root + "fresnel_defs.mtlx");
    for_each_model([&](const auto& row) {
        for (const std::string type : {"float", "color3"}) {
            if (row.parameters.size() == 0 && type == "color3") continue;
            const std::string name = "ND_fresnel_" + std::string(row.name);
            EXPECT_NE(definitions.find("\"" + name + "_" + type + "\""), std::string::npos) << name << type;
            EXPECT_NE(definitions.find("\"" + name + "_cos_" + type + "\""), std::string::npos)
                << name << type;
        }
    });
}

TEST(shader_packs, blender_has_a_shader_of_every_model_that_stands_alone) {
    const auto files = texts(emit::blender_pack());
    for_each_model([&](const auto& row) {
        const std::string name(row.name);
        const std::string& text = files.at("blender/fresnel_" + name + ".osl");
        EXPECT_NE(text.find("shader fresnel_" + name + "("), std::string::npos) << name;
        EXPECT_EQ(text.find("#include"), std::string::npos) << name;
        for (const auto& p : row.parameters)
            EXPECT_TRUE(
                std::regex_search(text, std::regex("(float|color|vector) " + std::string(p.name) + "_? = ")))
                << name << " has no socket " << p.name;
    });
}

TEST(shader_packs, no_file_is_there_twice) { EXPECT_GT(texts(emit::all_packs()).size(), 100u); }
