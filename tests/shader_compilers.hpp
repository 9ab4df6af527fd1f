#pragma once

// Compilers of shader text that the tests run as a user would.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace fresnel::test {

/// Whether a command is there to be run.
inline bool has_command(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

/// A test that writes shader text into a folder of its own and compiles it there.
class shader_test : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("fresnel_shader_" + std::to_string(getpid()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    /// Runs a command in the folder; its messages where it fails, otherwise nothing.
    std::string complaints(const std::string& command) const {
        const std::string log = (folder / "log").string();
        const int status =
            std::system(("cd '" + folder.string() + "' && (" + command + ") >'" + log + "' 2>&1").c_str());
        std::ifstream file(log);
        std::ostringstream text;
        text << command << "\n" << file.rdbuf();
        return status == 0 ? "" : text.str();
    }

    std::filesystem::path folder;
};

} // namespace fresnel::test
