#pragma once

// Runs the built command as a user would, through a shell, in a folder of its own.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace fresnel::test {

struct outcome {
    int code;
    std::string out, err;
};

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A test in an empty temporary folder, which must hold nothing unexpected afterwards.
class command_test : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 (std::string("fresnel_") + std::to_string(getpid()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "work");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    /// Runs `fresnel ARGUMENTS` in folder/work; `before` is put in front of it, for pipes.
    outcome run(const std::string& arguments, const std::string& before = "") const {
        const std::string line = "cd '" + (folder / "work").string() + "' && { " + before + "'" +
                                 FRESNEL_COMMAND + "' " + arguments + "; } >'" + (folder / "out").string() +
                                 "' 2>'" + (folder / "err").string() + "'";
        const int status = std::system(line.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder / "out"),
                read_text(folder / "err")};
    }

    nlohmann::json json(const std::string& arguments) const {
        const outcome result = run(arguments);
        EXPECT_EQ(result.code, 0) << arguments << "\n" << result.err;
        return nlohmann::json::parse(result.out);
    }

    /// Writes a file into folder/work.
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / "work" / name, std::ios::binary) << text;
    }

    /// The names of the files in folder/work.
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "work"))
            names.push_back(entry.path().lexically_relative(folder / "work").string());
        std::sort(names.begin(), names.end());
        return names;
    }

    /// Bad use: exit code 2, one line on standard error that holds every given piece, no new file.
    void expect_refused(const std::string& arguments, const std::vector<std::string>& pieces,
                        const std::string& before = "") const {
        const std::vector<std::string> earlier = files();
        const outcome result = run(arguments, before);
        EXPECT_EQ(result.code, 2) << arguments << "\n" << result.err;
        EXPECT_EQ(result.err.rfind("fresnel: ", 0), 0u) << arguments << "\n" << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        for (const std::string& piece : pieces)
            EXPECT_NE(result.err.find(piece), std::string::npos) << arguments << "\nlacks: " << piece << "\n"
                                                                 << result.err;
        EXPECT_EQ(files(), earlier) << arguments << " left something behind";
    }

    std::filesystem::path folder;
};

} // namespace fresnel::test
