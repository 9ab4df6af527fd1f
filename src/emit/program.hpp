#pragma once

#include "emit/language.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// A program of a vertex and a fragment stage, said once and printed in each shading language.

namespace fresnel::emit {

/// The types of a program's values.
enum class shape { scalar, two, three, four, matrix3, matrix4, map, cube };

enum class stage { vertex = 1, fragment = 2, both = 3 };

/// What the user of a program sets or a stage hands on; `meaning` stands beside its declaration.
struct declared {
    std::string name;
    shape type;
    std::string meaning;
};

/// How a language writes the parts of a program.
struct dialect {
    std::string_view id;                   ///< as `--lang` takes it
    std::string_view functions;            ///< the language that its functions are printed in
    std::string_view title;                ///< as a reader knows it
    std::array<std::string_view, 8> types; ///< in the order of shape
    std::string_view member; ///< how an input and a uniform are reached: "", or "input." and "u."
    std::string_view uniform;
    std::string_view sample_map, sample_cube; ///< {0} the texture, {1} the coordinate
    std::string_view mix;
    bool apart;        ///< each stage is a text of its own
    bool mul;          ///< mul(M, v) for M * v
    bool splat_weight; ///< the weight of a mix must have the width of what it mixes
    bool samplers;     ///< beside each texture stands its sampler, NAME_sampler

    const language& own() const { return find_language(functions); }
    std::string_view type(shape s) const { return types[static_cast<std::size_t>(s)]; }
};

/// GLSL, GLSL ES, HLSL from shader model 4, HLSL 2 and 3 with Cg, Slang, MSL and WGSL.
std::span<const dialect> dialects();

/// The dialect of that id; throws bad_input naming them all, OSL, CUDA and C have no such stages.
const dialect& find_dialect(std::string_view id);

/// Collects the two stages of a program: what they do, and with it what they need declared.
class program {
public:
    explicit program(const dialect& d) : d_(d) {}

    const dialect& of() const { return d_; }

    /// What may be used; only what is used is declared. A function comes after those that it calls.
    void uniform(declared x) { uniforms_.push_back({std::move(x)}); }
    void attribute(declared x) { attributes_.push_back({std::move(x)}); }
    void varying(declared x) { varyings_.push_back({std::move(x)}); }
    void function(std::string name, std::string text, std::string calls = {});

    /// Whether that name is taken by what may be used.
    bool declares(std::string_view name) const;

    /// From here on lines go into this stage.
    void begin(stage s) { now_ = s; }

    // ---- expressions ----

    std::string use(std::string_view uniform);
    /// An attribute in the vertex stage, a varying in the fragment stage.
    std::string in(std::string_view name);
    std::string call(const std::string& function, const std::vector<std::string>& arguments);
    std::string made(shape type, const std::vector<std::string>& parts) const;
    std::string product(const std::string& matrix, const std::string& vector) const;
    /// a where the weight is 0, b where it is 1; both have three components.
    std::string mix(const std::string& a, const std::string& b, const std::string& weight,
                    shape of_weight) const;
    /// Three components of a texture, or for a scalar its first one.
    std::string sample(std::string_view texture, const std::string& coordinate, shape read = shape::three);
    /// A value limited to [0, 1].
    std::string limited(const std::string& value) const;
    std::string number(float x) const;

    // ---- statements of the stage begun ----

    /// A value with a name, which is returned.
    std::string let(shape type, const std::string& name, const std::string& value,
                    const std::string& comment = {});
    /// a where the comparison holds, otherwise b.
    std::string choice(const std::string& condition, const std::string& a, const std::string& b) const;
    void note(const std::string& comment);
    void out(std::string_view varying, const std::string& value);
    void clip_position(const std::string& value) { position_ = value; }
    void color(const std::string& value) { color_ = value; }

    /// The text of both stages, or of one.
    std::string text(const std::vector<std::string>& head, stage wanted) const;

private:
    struct item {
        declared what;
        int stages = 0;
        bool used_by(int mask) const { return (stages & mask) != 0; }
        bool is_texture() const { return what.type == shape::map || what.type == shape::cube; }
    };
    struct helper {
        std::string name, text, calls;
        int stages = 0;
    };

    void mark(const std::string& function);
    void line(const std::string& text);
    static item& find(std::vector<item>& items, std::string_view name);
    std::string declarations(int stages) const;
    std::string globals(int stages) const;
    std::string textures(int stages) const;
    std::string member(const declared& x, bool attribute, int location) const;
    std::string structure(std::string_view name, bool attributes) const;
    std::string helpers(int stages) const;
    std::string entry(stage s) const;
    std::string glsl_stage(stage s) const;
    std::string returned(stage s) const;
    std::string uniform_block(int stages) const;

    const dialect& d_;
    stage now_ = stage::vertex;
    std::vector<item> uniforms_, attributes_, varyings_;
    std::vector<helper> helpers_;
    std::string vertex_, fragment_, position_, color_;
};

} // namespace fresnel::emit
