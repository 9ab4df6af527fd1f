// MaterialX: a data library with a node for every model. A node's reflectance is source text in GLSL, which every
// hardware target of MaterialX inherits, and in OSL; the angle between normal and view is put before it by a graph.

#include "emit/packs/materialx.hpp"
#include "emit/library.hpp"
#include "emit/pack.hpp"
#include "emit/packs/label.hpp"
#include "figure/figure.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

constexpr std::string_view root = "materialx/libraries/fresnel/";

/// An input or output of a node.
struct port {
    std::string name;
    int width = 1;
    std::string attributes = {}; ///< value, range, what it is
};

/// A node that source text implements, for one type of its values.
struct node {
    std::string category; ///< "fresnel_schlick_cos"
    std::string suffix;   ///< of its definition: "float" or "color3"
    std::string doc;
    std::vector<port> inputs, outputs;
    std::string file; ///< of its source text, without the extension

    std::string definition() const { return fmt::format("ND_{}_{}", category, suffix); }
    std::string function() const { return fmt::format("mx_{}_{}", category, suffix); }
};

// ---- what stands in a definition --------------------------------------------------------------------------

std::string values(double x, int width) {
    const std::string one = fmt::format("{:.7g}", x);
    return width == 1 ? one : fmt::format("{0}, {0}, {0}", one);
}

// Where a slider ends of a parameter whose range is far wider than what is asked for.
double slider_end(const parameter& p) {
    if (p.max <= 1) return p.max;
    if (p.name == "n_i" || p.name == "n_t" || p.name == "n") return 5;
    return 10;
}

port port_of(const parameter& p, int width) {
    return {std::string(p.name), width,
            fmt::format(R"(value="{}" uimin="{}" uimax="{}" uisoftmax="{}" uiname="{}" doc="{}")",
                        values(p.default_value, width), values(p.min, width), values(p.max, width),
                        values(slider_end(p), width), parameter_label(p.name), markup_text(p.meaning))};
}

port cosine_port() {
    return {"cos_i", 1, R"(value="1" uimin="0" uimax="1" uiname="Cosine" doc="Cosine of incidence")"};
}

std::vector<port> direction_ports() {
    return {
        {"normal", 3, R"(defaultgeomprop="Nworld" uiname="Normal" doc="Unit normal")"},
        {"viewdirection", 3,
         R"(defaultgeomprop="Vworld" uiname="View Direction" doc="Unit direction from the eye to the surface")"}};
}

std::string_view type_of(const port& p, std::string_view triple = "color3") {
    if (p.width == 1) return "float";
    return p.name == "normal" || p.name == "viewdirection" ? "vector3" : triple;
}

std::string definition_text(const node& n) {
    std::string text = fmt::format(
        "  <nodedef name=\"{}\" node=\"{}\" nodegroup=\"math\" version=\"{}\" isdefaultversion=\"true\" "
        "doc=\"{}\">\n",
        n.definition(), n.category, FRESNEL_VERSION, markup_text(n.doc));
    for (const port& p : n.inputs)
        text += fmt::format("    <input name=\"{}\" type=\"{}\" {} />\n", p.name, type_of(p), p.attributes);
    for (const port& p : n.outputs)
        text += fmt::format("    <output name=\"{}\" type=\"{}\" />\n", p.name, type_of(p));
    return text + "  </nodedef>\n";
}

// ---- the nodes --------------------------------------------------------------------------------------------

std::vector<port> ports_of(const function& f, const model_row<double>& row) {
    std::vector<port> ports;
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
        ports.push_back(port_of(row.parameters[i], f.arguments[i].width));
    ports.push_back(cosine_port());
    return ports;
}

std::string prefixed(std::string_view name) { return fmt::format("fresnel_{}", name); }

std::vector<node> nodes_of(const model_row<double>& row) {
    const std::string name = prefixed(row.name), model(row.name);
    const std::string doc = fmt::format("{} {}", row.summary, row.equation);
    std::vector<node> nodes;
    for (const int width : {1, 3}) {
        const function f = record(model, {width, false, {}});
        if (f.width() != width) continue;
        const std::string suffix = width == 1 ? "float" : "color3";
        nodes.push_back({name + "_cos", suffix, doc, ports_of(f, row), {{"out", width}}, "mx_" + name});
        if (width == 1 && row.polarised()) {
            std::vector<port> outputs;
            for (const result& r : record(model, {1, true, {}}).results)
                outputs.push_back({r.name});
            nodes.push_back(
                {name + "_boundary", suffix,
                 fmt::format("{} Reflectance R and transmittance T of both polarisations, across (s) and "
                             "along (p) the plane of incidence.",
                             row.summary),
                 ports_of(f, row), outputs, "mx_" + name + "_boundary"});
        }
    }
    return nodes;
}

node cosine_node() {
    return {
        "fresnel_cosine",
        "float",
        "Cosine of incidence, 0 where the surface is seen from behind. For a light or a half vector give its "
        "negative as viewdirection.",
        direction_ports(),
        {{"out"}},
        "mx_fresnel_cosine"};
}

node helper_node(const function& f) {
    std::vector<port> inputs;
    for (const argument& a : f.arguments) {
        if (a.name == "cos_i")
            inputs.push_back(cosine_port());
        else if (a.name == "f0")
            inputs.push_back(port_of(row::f0, 1));
        else
            inputs.push_back({a.name, 1,
                              R"(value="1.5" uimin="0.001" uimax="1000" uisoftmax="5" uiname="Relative IOR" )"
                              R"(doc="Relative index of refraction, n_t / n_i")"});
    }
    const std::string name = prefixed(f.name);
    return {name, "float", f.comment.front(), inputs, {{"out"}}, "mx_" + name};
}

// The same node with normal and viewdirection in place of the cosine.
node by_view(node n) {
    n.category.resize(n.category.size() - std::string_view("_cos").size());
    n.inputs.pop_back();
    for (port& p : direction_ports())
        n.inputs.push_back(std::move(p));
    return n;
}

std::string graph_text(const node& at_cosine) {
    const node n = by_view(at_cosine);
    const std::string type(type_of(n.outputs.front()));
    std::string text = fmt::format("  <nodegraph name=\"NG_{}_{}\" nodedef=\"{}\">\n"
                                   "    <fresnel_cosine name=\"cos_i\" type=\"float\">\n",
                                   n.category, n.suffix, n.definition());
    for (const port& p : direction_ports())
        text += fmt::format("      <input name=\"{0}\" type=\"vector3\" interfacename=\"{0}\" />\n", p.name);
    text += fmt::format("    </fresnel_cosine>\n    <{} name=\"reflectance\" type=\"{}\">\n",
                        at_cosine.category, type);
    for (std::size_t i = 0; i + 1 < at_cosine.inputs.size(); ++i)
        text += fmt::format("      <input name=\"{0}\" type=\"{1}\" interfacename=\"{0}\" />\n",
                            at_cosine.inputs[i].name, type_of(at_cosine.inputs[i]));
    return text +
           fmt::format("      <input name=\"cos_i\" type=\"float\" nodename=\"cos_i\" />\n    </{}>\n"
                       "    <output name=\"out\" type=\"{}\" nodename=\"reflectance\" />\n  </nodegraph>\n",
                       at_cosine.category, type);
}

// ---- source text ------------------------------------------------------------------------------------------

/// How a target of MaterialX is written.
struct target {
    const language& l;
    std::string_view id, output; ///< its name, what stands before an argument that is written to
};

// GLSL as MaterialX also gives it to Metal, whose C++ has no constructor of a struct's members.
const language& glsl_for_all() {
    static const language l = [] {
        language glsl = find_language("glsl");
        glsl.structs = struct_style::members;
        return glsl;
    }();
    return l;
}

std::vector<target> targets() {
    return {{glsl_for_all(), "genglsl", "out"}, {find_language("osl"), "genosl", "output"}};
}

// The function that MaterialX calls: inputs, then outputs.
std::string entry_text(const target& t, const node& n, std::string_view body) {
    std::vector<std::string> arguments;
    for (const port& p : n.inputs)
        arguments.push_back(fmt::format("{} {}",
                                        p.width == 1              ? t.l.scalar
                                        : type_of(p) == "vector3" ? t.l.vector
                                                                  : t.l.triple,
                                        legal_name(t.l, p.name)));
    for (const port& p : n.outputs)
        arguments.push_back(
            fmt::format("{} {} {}", t.output, t.l.type(p.width), p.name == "out" ? "result" : p.name));
    return fmt::format("void {}({}) {{\n{}}}\n", n.function(), fmt::join(arguments, ", "), body);
}

std::string call_text(const target& t, const node& n, const std::string& function) {
    std::vector<std::string> arguments;
    for (const port& p : n.inputs)
        arguments.push_back(legal_name(t.l, p.name));
    return call(function, arguments);
}

std::string entry_of(const target& t, const node& n) {
    const std::string function =
        prefixed(std::string_view(n.file).substr(std::string_view("mx_fresnel_").size()));
    if (n.outputs.size() == 1)
        return entry_text(t, n, fmt::format("    result = {};\n", call_text(t, n, function)));
    std::string body = fmt::format("    fresnel_boundary boundary = {};\n", call_text(t, n, function));
    for (const port& p : n.outputs)
        body += fmt::format("    {0} = boundary.{0};\n", p.name);
    return entry_text(t, n, body);
}

std::string source_path(const target& t, std::string_view file) {
    return fmt::format("{}{}/{}.{}", root, t.id, file, t.l.extension);
}

void add_model_sources(const target& t, const model_row<double>& row, std::vector<pack_file>& files) {
    const std::vector<node> nodes = nodes_of(row);
    const std::string name = prefixed(row.name);
    const model_request request{std::string(row.name), {}, name};
    const auto include = [&](std::string_view file) {
        return fmt::format("#include \"lib/{}.{}\"\n\n", file, t.l.extension);
    };
    const std::string twofold = twofold_text_for(t.l, request).empty() ? "" : include("fresnel_twofold");
    std::string text = scalar_text(t.l, request);
    if (const std::string channels = channels_text(t.l, request); !channels.empty()) text += "\n" + channels;
    for (const node& n : nodes)
        if (n.outputs.size() == 1) text += "\n" + entry_of(t, n);
    // a shader may use a node for numbers and for colours, and then holds the file twice
    files.push_back({source_path(t, "mx_" + name), twofold + guarded(name, text)});
    for (const node& n : nodes)
        if (n.outputs.size() > 1)
            files.push_back({source_path(t, n.file), include("fresnel_boundary") + twofold +
                                                         boundary_text(t.l, request) + "\n" +
                                                         entry_of(t, n)});
}

std::string helper_source(const target& t, function f) {
    const node n = helper_node(f);
    f.name = prefixed(f.name);
    return print(t.l, f) + "\n" + entry_of(t, n);
}

std::string cosine_source(const target& t) {
    function f = record_geometry().front();
    f.name = prefixed(f.name);
    const std::string body =
        fmt::format("    result = {};\n", call(f.name, {legal_name(t.l, "normal"), "-viewdirection"}));
    return print(t.l, f) + "\n" + entry_text(t, cosine_node(), body);
}

// ---- the files --------------------------------------------------------------------------------------------

std::vector<node> source_nodes() {
    std::vector<node> nodes = {cosine_node()};
    for (const model_row<double>& row : model_table<double>())
        for (node& n : nodes_of(row))
            nodes.push_back(std::move(n));
    for (const function& f : materialx_functions())
        nodes.push_back(helper_node(f));
    return nodes;
}

bool takes_cosine_alone(const node& n) { return n.category.ends_with("_cos"); }

std::string document(std::string_view what, const std::string& content) {
    return fmt::format(
        "<?xml version=\"1.0\"?>\n<materialx version=\"1.39\">\n"
        "  <!-- fresnel {}: {}. Made by `fresnel shader --write`; do not edit. -->\n\n{}</materialx>\n",
        FRESNEL_VERSION, what, content);
}

std::string definitions_document(const std::vector<node>& nodes) {
    std::string text;
    for (const node& n : nodes)
        text += (takes_cosine_alone(n) ? definition_text(by_view(n)) + "\n" : "") + definition_text(n) + "\n";
    text.pop_back();
    return document("definitions of nodes", text);
}

std::string graphs_document(const std::vector<node>& nodes) {
    std::string text;
    for (const node& n : nodes)
        if (takes_cosine_alone(n)) text += graph_text(n) + "\n";
    text.pop_back();
    return document("nodes that take normal and viewdirection", text);
}

std::string implementations_document(const target& t, const std::vector<node>& nodes) {
    std::string text;
    for (const node& n : nodes)
        text += fmt::format("  <implementation name=\"IM_{0}_{1}_{2}\" nodedef=\"{3}\" file=\"{4}.{5}\" "
                            "function=\"{6}\" target=\"{2}\" />\n",
                            n.category, n.suffix, t.id, n.definition(), n.file, t.l.extension, n.function());
    return document(fmt::format("implementations in {}", t.l.title), text);
}

} // namespace

std::vector<pack_file> materialx_pack() {
    const std::vector<node> nodes = source_nodes();
    std::vector<pack_file> files = {
        {"materialx/README.md", materialx_readme()},
        {"materialx/examples/copper.mtlx", materialx_example()},
        {fmt::format("{}fresnel_defs.mtlx", root), definitions_document(nodes)},
        {fmt::format("{}fresnel_ng.mtlx", root), graphs_document(nodes)},
    };
    for (const target& t : targets()) {
        files.push_back(
            {fmt::format("{0}{1}/fresnel_{1}_impl.mtlx", root, t.id), implementations_document(t, nodes)});
        files.push_back({source_path(t, "lib/fresnel_boundary"), boundary_type(t.l)});
        files.push_back({source_path(t, "lib/fresnel_twofold"), twofold_text(t.l)});
        files.push_back({source_path(t, "mx_fresnel_cosine"), cosine_source(t)});
        for (const function& f : materialx_functions())
            files.push_back({source_path(t, helper_node(f).file), helper_source(t, f)});
        for (const model_row<double>& row : model_table<double>())
            add_model_sources(t, row, files);
    }
    return files;
}

} // namespace fresnel::emit
