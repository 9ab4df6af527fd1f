// receivers_corpus WORDS DIR
// Writes, for each language L that the emitter knows, what its receivers compile beside the text that the command
// prints:
//   DIR/L/names.EXT     one function for each word of WORDS and for each reserved word of any language, called by it
//   DIR/L/hostile.EXT   a few such names again, with every form of a function: RGB, two directions, polarisations
#include "emit/library.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

namespace {

using namespace fresnel;

// Names that a keyword, a function of the language, or the text around ours already has.
constexpr std::array hostile = {"mix",
                                "sample",
                                "new",
                                "__x",
                                "half",
                                "float3",
                                "texture",
                                "main",
                                "gl_x",
                                "operator",
                                "fn",
                                "surface",
                                "normal",
                                "direction",
                                "incidence_cosine",
                                "cos_i",
                                "f0",
                                "f90",
                                "m",
                                "R",
                                "R_s",
                                "fresnel_boundary",
                                "result",
                                "b",
                                "fresnel_float3",
                                "fresnel_dot",
                                "FRESNEL_FUNCTION",
                                "make_float3",
                                "FRESNEL_C",
                                "9lives",
                                "a b",
                                "let",
                                "_",
                                "",
                                "caf\xc3\xa9",
                                "n_i",
                                "n_t",
                                "cos_t",
                                "saturate",
                                "vec3f"};

std::vector<std::string> words_of(const char* file) {
    std::ifstream in(file);
    std::vector<std::string> words;
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream fields(line.substr(0, line.find('#')));
        words.insert(words.end(), std::istream_iterator<std::string>(fields), {});
    }
    if (words.empty()) throw bad_input(fmt::format("'{}': has no words", file));
    for (const emit::language& l : emit::languages())
        for (const std::string& word : emit::reserved_words(l))
            words.push_back(word);
    return words;
}

// Functions of ours, one for each word; a second word that becomes the same name in the language is left out.
template <class Make>
std::string functions(const emit::language& l, const auto& words, Make&& make) {
    std::set<std::string> taken;
    std::string text;
    for (const auto& word : words)
        if (*std::data(std::string_view(word)) != '\0' && taken.insert(emit::function_name(l, word)).second)
            text += "\n" + make(std::string(word));
    return text;
}

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

void write_language(const emit::language& l, const std::vector<std::string>& words,
                    const std::filesystem::path& root) {
    const std::filesystem::path folder = root / l.id;
    std::filesystem::create_directories(folder);
    const emit::style plain = {.precise = false, .comment = false};
    const auto wrapped = [&](const std::string& text) {
        return emit::preamble(l, "receivers_corpus", std::array{emit::model_request{"dielectric"}}) + text;
    };
    write(folder / fmt::format("names.{}", l.extension), wrapped(functions(l, words, [&](std::string word) {
              return emit::scalar_text(l, {"schlick", {}, word}, plain);
          })));
    write(folder / fmt::format("hostile.{}", l.extension),
          wrapped(functions(l, hostile,
                            [&](std::string word) {
                                return emit::model_text(l, {"schlick_f90", {}, word}, plain);
                            }) +
                  functions(l, hostile, [&](std::string word) {
                      return emit::model_text(l, {"dielectric", {}, word + "_d"}, plain);
                  })));
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "usage: receivers_corpus WORDS DIR\n";
        return 2;
    }
    try {
        const std::vector<std::string> words = words_of(arguments[1]);
        for (const emit::language& l : emit::languages())
            write_language(l, words, arguments[2]);
    } catch (const std::exception& error) {
        std::cerr << "receivers_corpus: " << error.what() << "\n";
        return 1;
    }
}
