#pragma once

// Reads Unity's ShaderLab as far as the shaders of the pack go: what is not known here is a complaint.

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::test {

/// The program of a pass: what all passes include, then its own lines.
struct shader_pass {
    std::string name, text, vertex, fragment;
};

class shader_lab {
public:
    explicit shader_lab(std::string text) : text_(std::move(text)) {
        read_shader();
        if (complaints.empty()) compare_properties();
    }

    std::string name;
    std::vector<std::string> properties;
    std::vector<shader_pass> passes;
    std::vector<std::string> complaints; ///< "line 12: Pass has no 'Bled'"; reading ends at the first

private:
    struct broken {};

    // ---- tokens ---------------------------------------------------------------------------------------------

    [[noreturn]] void refuse(const std::string& what) {
        const auto line =
            1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        complaints.push_back("line " + std::to_string(line) + ": " + what);
        throw broken{};
    }

    void skip_blanks() {
        for (;;) {
            while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
                ++at_;
            if (text_.compare(at_, 2, "//") != 0) return;
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
    }

    // The next word, string with its quotes, or sign; empty at the end.
    std::string peek() {
        skip_blanks();
        if (at_ == text_.size()) return {};
        if (text_[at_] == '"') {
            const std::size_t end = text_.find('"', at_ + 1);
            if (end == std::string::npos) refuse("a string has no end");
            return text_.substr(at_, end + 1 - at_);
        }
        std::size_t end = at_;
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) != 0 ||
                                      text_[end] == '_' || text_[end] == '.' || text_[end] == '-'))
            ++end;
        return text_.substr(at_, std::max<std::size_t>(end - at_, 1));
    }

    std::string take() {
        std::string token = peek();
        if (token.empty()) refuse("the text ends inside a block");
        at_ += token.size();
        return token;
    }

    void expect(const std::string& wanted) {
        const std::string found = peek();
        if (found != wanted) refuse("'" + found + "' where '" + wanted + "' must stand");
        take();
    }

    std::string take_string() {
        const std::string token = peek();
        if (token.empty() || token.front() != '"') refuse("'" + token + "' where a string must stand");
        take();
        return token.substr(1, token.size() - 2);
    }

    void take_number() {
        const std::string token = peek();
        if (!std::regex_match(token, std::regex("-?[0-9]+(\\.[0-9]+)?")))
            refuse("'" + token + "' where a number must stand");
        take();
    }

    std::string take_one_of(std::initializer_list<std::string_view> words) {
        const std::string token = peek();
        if (std::find(words.begin(), words.end(), token) == words.end())
            refuse("'" + token + "' is none of the words known here");
        return take();
    }

    // Everything up to the end of a program.
    std::string take_program(const std::string& begin) {
        const std::string end = begin.starts_with("CG") ? "ENDCG" : "ENDHLSL";
        const std::size_t stop = text_.find(end, at_);
        if (stop == std::string::npos) refuse(begin + " has no " + end);
        const std::string program = text_.substr(at_, stop - at_);
        at_ = stop + end.size();
        if (program.find("PROGRAM") != std::string::npos || program.find("INCLUDE\n") != std::string::npos)
            refuse(begin + " has no " + end);
        return program;
    }

    // ---- blocks ---------------------------------------------------------------------------------------------

    void read_shader() try {
        expect("Shader");
        name = take_string();
        expect("{");
        expect("Properties");
        read_properties();
        do {
            expect("SubShader");
            read_subshader();
        } while (peek() == "SubShader");
        if (peek() == "FallBack") take(), take_string();
        expect("}");
        if (!peek().empty()) refuse("'" + peek() + "' behind the shader");
    } catch (const broken&) {
    }

    void read_properties() {
        expect("{");
        while (peek() != "}") {
            if (peek() == "[") {
                take();
                take_one_of({"Normal", "HDR", "NoScaleOffset", "MainTexture", "Gamma"});
                expect("]");
            }
            const std::string property = take();
            if (!std::regex_match(property, std::regex("_[A-Z][A-Za-z0-9]*")))
                refuse("'" + property + "' is no name of a property");
            if (std::find(properties.begin(), properties.end(), property) != properties.end())
                refuse(property + " is declared twice");
            properties.push_back(property);
            expect("("), take_string(), expect(",");
            const std::string type = take_one_of({"Color", "Vector", "2D", "Cube", "Float", "Range"});
            if (type == "Range") expect("("), take_number(), expect(","), take_number(), expect(")");
            expect(")"), expect("=");
            read_default(type);
        }
        expect("}");
    }

    void read_default(const std::string& type) {
        if (type == "2D" || type == "Cube") {
            take_string(), expect("{"), expect("}");
            return;
        }
        const bool four = type == "Color" || type == "Vector";
        if (!four) return take_number();
        expect("("), take_number();
        for (int i = 0; i < 3; ++i)
            expect(","), take_number();
        expect(")");
    }

    void read_pairs(const std::string& sign) {
        expect("{");
        while (peek() != "}")
            take_string(), expect(sign), take_string();
        expect("}");
    }

    // Tags and the state of the fixed stages, in a SubShader and a Pass alike.
    bool read_common(const std::string& word) {
        if (word == "Tags") {
            read_pairs("=");
        } else if (word == "Blend") {
            const std::initializer_list<std::string_view> factors = {
                "One", "Zero", "SrcAlpha", "OneMinusSrcAlpha", "DstColor", "SrcColor", "OneMinusDstColor"};
            take_one_of(factors), take_one_of(factors);
        } else if (word == "ZWrite") {
            take_one_of({"On", "Off"});
        } else if (word == "ColorMask") {
            take_one_of({"R", "RGB", "0"});
        } else if (word == "Cull") {
            take_one_of({"Back", "Front", "Off"});
        } else if (word == "LOD") {
            take_number();
        } else {
            return false;
        }
        return true;
    }

    void read_subshader() {
        expect("{");
        for (bool first = true; peek() != "}"; first = false) {
            const std::string word = take();
            if (word == "PackageRequirements") {
                if (!first) refuse("PackageRequirements must come first");
                read_pairs(":");
            } else if (word == "CGINCLUDE" || word == "HLSLINCLUDE") {
                included_ += take_program(word);
            } else if (word == "Pass") {
                read_pass();
            } else if (!read_common(word)) {
                refuse("SubShader has no '" + word + "'");
            }
        }
        expect("}");
        if (passes.empty()) refuse("SubShader has no Pass");
    }

    void read_pass() {
        shader_pass pass;
        expect("{");
        while (peek() != "}") {
            const std::string word = take();
            if (word == "Name")
                pass.name = take_string();
            else if (word == "CGPROGRAM" || word == "HLSLPROGRAM")
                pass.text = take_program(word);
            else if (!read_common(word))
                refuse("Pass has no '" + word + "'");
        }
        expect("}");
        pass.vertex = entry_of(pass.text, "vertex");
        pass.fragment = entry_of(pass.text, "fragment");
        pass.text = included_ + pass.text;
        passes.push_back(pass);
    }

    std::string entry_of(const std::string& program, const std::string& stage) {
        std::smatch found;
        if (!std::regex_search(program, found, std::regex("#pragma " + stage + " (\\w+)")))
            refuse("the program names no " + stage + " function");
        return found[1];
    }

    // ---- properties and uniforms ----------------------------------------------------------------------------

    std::set<std::string> declared_uniforms() const {
        std::set<std::string> names;
        const std::regex declaration(
            "(?:^|\\n)[ ]*(?:float[234]?|sampler2D|samplerCUBE|TEXTURE2D|TEXTURECUBE)"
            "[ (](_\\w+(?:, _\\w+)*)\\)?;");
        const std::regex word("_\\w+");
        for (const shader_pass& pass : passes)
            for (std::sregex_iterator d(pass.text.begin(), pass.text.end(), declaration), end; d != end;
                 ++d) {
                const std::string list = (*d)[1];
                for (std::sregex_iterator w(list.begin(), list.end(), word); w != end; ++w)
                    names.insert(w->str());
            }
        return names;
    }

    static int occurrences(const std::string& text, const std::string& word) {
        const std::regex whole("\\b" + word + "\\b");
        return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), whole), {}));
    }

    void compare_properties() {
        const std::set<std::string> uniforms = declared_uniforms();
        for (const std::string& uniform : uniforms) {
            std::string owner = uniform;
            if (owner.ends_with("_ST")) owner.resize(owner.size() - 3);
            if (std::find(properties.begin(), properties.end(), owner) == properties.end())
                complaints.push_back("the programs declare " + uniform + ", which is no property");
        }
        for (const std::string& property : properties) {
            // Unity's own includes declare the colour of highlights
            const bool declared = uniforms.contains(property) || property == "_SpecColor";
            if (!declared) complaints.push_back("no program declares the property " + property);
            bool used = false;
            for (const shader_pass& pass : passes)
                used = used || occurrences(pass.text, property) > (uniforms.contains(property) ? 1 : 0);
            if (!used) complaints.push_back("no program uses the property " + property);
        }
    }

    std::string text_, included_;
    std::size_t at_ = 0;
};

} // namespace fresnel::test
