// What the command costs its user: start-up time, and time and memory for a million rows of CSV.
// Run build/release/command_bench; it prints one line per measurement (best of five).

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

struct usage {
    double seconds;
    double megabytes;
};

usage run(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& a : arguments)
        argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = fork();
    if (child == 0) {
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        execv(argv[0], argv.data());
        _exit(127);
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    if (status != 0) fmt::print(stderr, "{}: failed\n", arguments[1]), std::exit(1);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return {elapsed.count(), static_cast<double>(used.ru_maxrss) / 1024};
}

void measure(const std::string& what, const std::vector<std::string>& arguments) {
    usage best = run(arguments);
    for (int i = 0; i < 4; ++i) {
        const usage again = run(arguments);
        best = {std::min(best.seconds, again.seconds), std::max(best.megabytes, again.megabytes)};
    }
    fmt::print("{:<44} {:>8.3f} s {:>7.1f} MB\n", what, best.seconds, best.megabytes);
}

std::string write_rows(const std::string& path) {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::FILE* file = std::fopen(path.c_str(), "w");
    fmt::print(file, "n_t,k_t,cos_i\n");
    for (int i = 0; i < 1'000'000; ++i)
        fmt::print(file, "{},{},{}\n", 0.1 + 3 * unit(generator), 8 * unit(generator), unit(generator));
    std::fclose(file);
    return path;
}

} // namespace

int main() {
    const std::string rows = write_rows(
        (std::filesystem::temp_directory_path() / fmt::format("fresnel_rows_{}.csv", getpid())).string());
    const std::string command = FRESNEL_COMMAND;
    measure("fresnel models", {command, "models"});
    measure("fresnel materials", {command, "materials"});
    measure("fresnel f0 copper", {command, "f0", "copper"});
    for (const char* type : {"float", "double"})
        measure(fmt::format("fresnel eval conductor --csv, 1e6 rows, {}", type),
                {command, "eval", "conductor", "--csv", rows, "--type", type});
    std::filesystem::remove(rows);
}
