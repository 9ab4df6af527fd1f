#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace fresnel::cli {

/// What `fresnel shader --verify` is given beside the models.
struct verify_options {
    bool wanted = false, json = false;
    std::string rows, dump, compare;
};

void add_verify_options(CLI::App& command, verify_options& given);

/// Prints the table. Throws failure where a claim does not hold.
void run_verify(const verify_options& given, const std::vector<std::string>& models);

} // namespace fresnel::cli
