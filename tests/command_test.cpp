// The command as scripts use it: keys, exit codes, CSV, and every kind of bad input.

#include "command.hpp"

#include "analysis/model_table.hpp"

#include <cmath>

namespace {

using command = fresnel::test::command_test;

bool has(const nlohmann::json& object, const std::vector<std::string>& keys) {
    return std::all_of(keys.begin(), keys.end(),
                       [&](const std::string& key) { return object.contains(key); });
}

// ---- help -------------------------------------------------------------------------------------------------

TEST_F(command, help_of_every_command_shows_examples) {
    for (const char* name : {"", "models", "eval", "materials", "materials show", "f0", "compare"}) {
        const auto result = run(std::string(name) + " --help");
        EXPECT_EQ(result.code, 0) << name;
        EXPECT_NE(result.out.find("Examples:"), std::string::npos) << name;
    }
}

// The examples of a help text, without the remark that follows three spaces and what a pipe leads to.
std::vector<std::string> examples_of(const std::string& help) {
    std::vector<std::string> lines;
    std::istringstream text(help.substr(help.find("Examples:")));
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("  fresnel ", 0) != 0) continue;
        line.erase(0, std::string("  fresnel ").size());
        lines.push_back(line.substr(0, std::min(line.find("   "), line.find('|'))));
    }
    return lines;
}

// Of the commands that are done in a moment; not those of a file that the reader would have to have.
TEST_F(command, help_shows_examples_that_work) {
    for (const char* name :
         {"models", "eval", "materials", "materials show", "f0", "angles", "convert", "convert ior",
          "convert f0", "convert metalness", "convert opacity", "identify", "plot", "shader", "lut"}) {
        const std::vector<std::string> examples = examples_of(run(std::string(name) + " --help").out);
        EXPECT_GE(examples.size(), 2u) << name;
        for (const std::string& example : examples) {
            const bool slow = example.find("--verify") != std::string::npos;
            if (slow || example.find(" rows.csv") != std::string::npos ||
                example.find("my-measurement.csv") != std::string::npos)
                continue;
            const auto result = run(example);
            EXPECT_EQ(result.code, 0) << example << "\n" << result.err;
        }
    }
}

TEST_F(command, version_is_printed) { EXPECT_EQ(run("--version").out.rfind("fresnel ", 0), 0u); }

// ---- models -----------------------------------------------------------------------------------------------

TEST_F(command, models_prints_every_row_of_the_registry) {
    const nlohmann::json models = json("models --json");
    ASSERT_EQ(models.size(), fresnel::model_table<double>().size());
    for (const nlohmann::json& row : models) {
        EXPECT_TRUE(has(row, {"name", "kind", "equation", "parameters", "citation", "domain", "error"}))
            << row;
        for (const nlohmann::json& p : row["parameters"])
            EXPECT_TRUE(has(p, {"name", "unit", "min", "max", "default"}));
    }
    EXPECT_EQ(json("models schlick gulbrandsen --json").size(), 2u);
}

// ---- eval -------------------------------------------------------------------------------------------------

TEST_F(command, eval_gives_published_reflectances) {
    const nlohmann::json one = json("eval dielectric --n-t 1.5 --theta 80 --json");
    EXPECT_TRUE(has(one, {"model", "parameters", "results"}));
    EXPECT_NEAR(one["results"][0]["R"].get<double>(), 0.387704354691473, 1e-14);
    EXPECT_EQ(json("eval schlick --f0 0.04 --cos-i 1 --json")["results"][0]["R"], 0.04);
    EXPECT_EQ(json("eval dielectric --n_t 1.5 --cos_i 1 --json")["results"].size(), 1u);
}

TEST_F(command, eval_sweeps_and_takes_lists) {
    EXPECT_EQ(json("eval schlick --f0 0.04 --theta 0:90:91 --json")["results"].size(), 91u);
    EXPECT_EQ(json("eval schlick --f0 0.04 --cos-i 0,0.5,1 --json")["results"].size(), 3u);
    EXPECT_EQ(json("eval schlick --json")["results"].size(), 10u);
    EXPECT_EQ(json("eval one_minus_cos --json")["parameters"], nlohmann::json::object());
}

// Rounding left 90.00000000000001.
TEST_F(command, a_sweep_stays_between_its_ends) {
    for (const char* sweep : {"90:90:8", "0:90:1000", "90:0:997"})
        EXPECT_EQ(run(std::string("eval schlick --theta ") + sweep).code, 0) << sweep;
    EXPECT_EQ(run("plot dielectric --family n_t=1000:1000:8").code, 0);
    expect_refused("eval schlick --theta 90.1:90.1:8", {"theta = 90.1", "[0, 90]"});
}

TEST_F(command, eval_takes_n_k_and_f0_from_a_material_of_any_kind) {
    const nlohmann::json copper = json("eval conductor --material copper --wavelength 650 --cos-i 1 --json");
    EXPECT_GT(copper["results"][0]["R"].get<double>(), 0.9);
    for (const char* name : {"skin", "olive-oil", "water"})
        EXPECT_EQ(run(std::string("eval schlick --material ") + name).code, 0) << name;
    const auto at_82 = [&](const std::string& model) {
        return json("eval " + model +
                    " --material gold --cos-i 0.14285714285714285 --json")["results"][0]["R"]
            .get<double>();
    };
    EXPECT_NEAR(at_82("f82"), at_82("conductor"), 1e-12);
    EXPECT_NEAR(at_82("f82_tint"), at_82("conductor"), 1e-12);
}

TEST_F(command, eval_takes_r_and_g_of_a_material_that_give_its_reflectance) {
    for (const std::string name : {"gold", "silver", "aluminium", "silicon", "n-bk7", "water", "vacuum"}) {
        const auto at = " --material " + name + " --theta 0:89:10 --json";
        const nlohmann::json exact = json("eval conductor" + at), edge = json("eval gulbrandsen" + at);
        for (std::size_t i = 0; i < 10; ++i)
            EXPECT_NEAR(edge["results"][i]["R"].get<double>(), exact["results"][i]["R"].get<double>(), 1e-12)
                << name << " " << i;
    }
    EXPECT_EQ(json("eval gulbrandsen --material gold --g 0.5 --json")["parameters"]["g"], 0.5);
    write("thin.csv", "wavelength_nm,n,k\n500,0.3,0.2\n");
    expect_refused("eval gulbrandsen --material thin.csv", {"n = 0.3, k = 0.2", "g"});
}

TEST_F(command, eval_fits_to_a_material_what_no_index_says) {
    const auto reflectances = [&](const std::string& model) {
        std::vector<double> all;
        const nlohmann::json report = json("eval " + model + " --theta 0:90:91 --json");
        for (const nlohmann::json& one : report["results"])
            all.push_back(one["R"]);
        return all;
    };
    const std::vector<double> exact = reflectances("conductor --material copper");
    ASSERT_EQ(exact.size(), 91u);
    for (const std::string model :
         {"bias_scale_power", "lazanyi", "schlick_power", "hoffman", "schlick_f90"}) {
        const std::vector<double> near = reflectances(model + " --material copper");
        for (std::size_t i = 0; i < exact.size(); ++i)
            EXPECT_NEAR(near[i], exact[i], model == "schlick_f90" ? 0.05 : 0.02) << model << " " << i;
    }
    const nlohmann::json given = json("eval hoffman --material copper --power 3 --json")["parameters"];
    EXPECT_EQ(given["power"], 3);
    EXPECT_EQ(given["f0"], json("eval schlick --material copper --json")["parameters"]["f0"]);
}

TEST_F(command, a_negative_zero_is_zero) {
    EXPECT_EQ(run("eval dielectric --cos-i -0 --json").out, run("eval dielectric --cos-i 0 --json").out);
    EXPECT_EQ(run("eval one_minus_cos --csv -", "printf 'cos_i\\n-0\\n' | ").out, "cos_i,R\n-0,1\n");
    EXPECT_EQ(run("eval dielectric --csv -", "printf 'n_t,cos_i\\n1.5,-0\\n' | ").out.find(",-0\n"),
              std::string::npos);
}

TEST_F(command, a_negative_number_need_not_begin_with_a_zero) {
    EXPECT_EQ(run("identify -.2").out, run("identify -0.2").out);
    EXPECT_EQ(run("identify -.2").code, 0);
    expect_refused("convert f0 -.1", {"F0 = -0.1", "[0, 1]"});
}

TEST_F(command, numbers_are_printed_so_that_they_read_back_as_the_same_double) {
    const double R =
        json("eval conductor --n-t 0.2 --k-t 3 --cos-i 0.3 --json")["results"][0]["R"].get<double>();
    const double values[] = {1, 0.2, 3};
    EXPECT_EQ(R, fresnel::find_model<double>("conductor").evaluate(values, 0.3).reflectance());
}

TEST_F(command, csv_keeps_the_columns_as_given_and_adds_the_results) {
    write("rows.csv", "cos_i,n_t\n1.0,1.50\n 0.5,2\n");
    const auto result = run("eval dielectric --csv rows.csv");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out.substr(0, result.out.find('\n')), "cos_i,n_t,Rs,Rp,R,Ts,Tp,T");
    EXPECT_NE(result.out.find("\n1.0,1.50,0.04"), std::string::npos) << result.out;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 3);
    EXPECT_EQ(run("eval schlick --csv -", "printf 'f0,cos_i\\r\\n0.04,1\\r\\n' | ").out,
              "f0,cos_i,R\n0.04,1,0.04\n");
}

TEST_F(command, csv_of_a_model_without_parameters_needs_cos_i_only) {
    EXPECT_EQ(run("eval one_minus_cos --csv -", "printf 'cos_i\\n0.25\\n' | ").out, "cos_i,R\n0.25,0.75\n");
}

TEST_F(command, csv_of_50_digits_is_right_to_50_digits) {
    const auto result = run("eval dielectric --csv - --type 50", "printf 'n_t,cos_i\\n1.5,0.1\\n' | ");
    // R_s = ((g - c) / (g + c))^2 with g^2 = 1.26 and c = 0.1, by mpmath at 70 digits
    EXPECT_NE(result.out.find("1.5,0.1,0.69956570512361685301570348364477304730392485202849,"),
              std::string::npos)
        << result.out;
}

TEST_F(command, csv_of_50_digits_takes_the_limits_as_they_are_printed) {
    write("rows.csv", "n_i,n_t,k_t,cos_i\n0.01,0.001,0,1\n1,0.001,0.1,0.5\n");
    for (const char* type : {"float", "double", "50"})
        EXPECT_EQ(run(std::string("eval conductor --csv rows.csv --type ") + type).code, 0) << type;
    expect_refused("eval dielectric --csv - --type 50", {"line 2, column 1 (n_t)", "[0.001, 1000]"},
                   "printf 'n_t,cos_i\\n0.00099999999999999999999,1\\n' | ");
}

TEST_F(command, csv_in_float_is_the_float_model) {
    const auto result = run("eval schlick --csv - --type float", "printf 'f0,cos_i\\n0.04,0.5\\n' | ");
    EXPECT_EQ(result.out, "f0,cos_i,R\n0.04,0.5,0.07\n");
}

TEST_F(command, csv_out_writes_a_file_that_is_complete_or_not_there) {
    write("rows.csv", "f0,cos_i\n0.04,1\n");
    EXPECT_EQ(run("eval schlick --csv rows.csv --out results.csv").code, 0);
    EXPECT_EQ(files(), (std::vector<std::string>{"results.csv", "rows.csv"}));
    EXPECT_EQ(fresnel::test::read_text(folder / "work" / "results.csv"), "f0,cos_i,R\n0.04,1,0.04\n");
}

TEST_F(command, csv_out_follows_links_and_writes_into_what_is_no_file) {
    write("rows.csv", "f0,cos_i\n0.04,1\n");
    const std::string rows = "f0,cos_i,R\n0.04,1,0.04\n";
    std::filesystem::create_symlink("results.csv", folder / "work" / "link.csv");
    EXPECT_EQ(run("eval schlick --csv rows.csv --out link.csv").code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "work" / "link.csv"));
    EXPECT_EQ(fresnel::test::read_text(folder / "work" / "results.csv"), rows);
    EXPECT_EQ(run("eval schlick --csv rows.csv --out pipe; wait", "mkfifo pipe; cat pipe & ").out, rows);
    EXPECT_EQ(run("eval schlick --csv rows.csv --out -").out, rows);
    EXPECT_EQ(run("eval schlick --csv rows.csv --out /dev/full").code, 1);
    EXPECT_EQ(files().size(), 4u) << "the link, the pipe, the results and the rows";
}

TEST_F(command, out_into_a_descriptor_of_ours_follows_what_was_written_there) {
    write("rows.csv", "f0,cos_i\n0.04,1\n");
    const std::string rows = "f0,cos_i,R\n0.04,1,0.04\n", before = "echo before; ";
    for (const char* out : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "-", "link", "/dev/fd/3 3>&1"}) {
        const std::string link = before + "ln -sf /dev/stdout link; ";
        EXPECT_EQ(run("eval schlick --csv rows.csv --out " + std::string(out), link).out, "before\n" + rows)
            << out;
    }
    const auto plot = run("plot schlick --out link.csv", before + "ln -s /dev/stdout link.csv; ");
    EXPECT_EQ(plot.out.rfind("before\nangle of incidence", 0), 0u) << plot.out;
    EXPECT_TRUE(plot.out.ends_with("wrote link.csv\n")) << plot.out;
    EXPECT_EQ(files().size(), 3u) << "two links and the rows";
}

// Ended by a signal, a program that ends so leaves a shell the code 128 + signal.
TEST_F(command, ended_by_a_signal_leaves_nothing) {
    const auto end_when = [](const std::string& there, const std::string& signal = "TERM") {
        return " & for i in $(seq 500); do ls -d " + there + " >/dev/null 2>&1 && break; sleep 0.02; done; " +
               "kill -" + signal + " $!; wait $!; echo $?";
    };
    EXPECT_EQ(run("figures --out out/figures >/dev/null" + end_when("out/figures/.*.part"),
                  "export TMPDIR=\"$PWD\"; ")
                  .out,
              "143\n");
    EXPECT_EQ(files(), std::vector<std::string>());
    const std::string pipe = "rm -f in; mkfifo in; exec 3<>in; ";
    for (const auto& [signal, code] : {std::pair("TERM", "143\n"), {"PIPE", "141\n"}, {"XFSZ", "153\n"}})
        EXPECT_EQ(run("eval schlick --csv in --out results.csv" + end_when("*.part", signal), pipe).out,
                  code);
    EXPECT_EQ(files(), std::vector<std::string>{"in"});
}

// A limit on the size of files stands for a full disk: the page is larger than every figure.
TEST_F(command, a_report_that_cannot_be_written_leaves_nothing) {
    const std::string full = "export TMPDIR=\"$PWD\"; trap '' XFSZ; ulimit -f 2; ";
    const auto result = run("compare vacuum --out out/report", full);
    EXPECT_EQ(result.code, 1) << result.err;
    EXPECT_EQ(run("shader --write shaders", full).code, 1);
    EXPECT_EQ(files(), std::vector<std::string>());
}

TEST_F(command, a_folder_in_the_place_of_a_file_is_refused_before_anything_is_moved) {
    for (const char* place : {"report.json", "index.html"}) {
        std::filesystem::remove_all(folder / "work" / "out");
        std::filesystem::create_directories(folder / "work" / "out" / place);
        const auto result = run("compare vacuum --out out");
        EXPECT_EQ(result.code, 2);
        EXPECT_NE(result.err.find("out/" + std::string(place) + ": is a folder"), std::string::npos)
            << result.err;
        EXPECT_EQ(files(), (std::vector<std::string>{"out", "out/" + std::string(place)}));
    }
}

TEST_F(command, csv_on_a_pipe_ends_after_the_last_complete_row) {
    const auto result =
        run("eval schlick --csv -", "printf 'f0,cos_i\\n0.04,1\\n0.5,1\\n0.04,2\\n0.04,1\\n' | ");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "f0,cos_i,R\n0.04,1,0.04\n0.5,1,0.5\n");
    EXPECT_NE(result.err.find("line 4, column 2 (cos_i): 2 is not in [0, 1]"), std::string::npos)
        << result.err;
}

// ---- materials and f0 ---------------------------------------------------------------------------------------

TEST_F(command, materials_lists_every_kind_with_its_provenance) {
    const nlohmann::json all = json("materials --json");
    std::map<std::string, int> kinds;
    for (const nlohmann::json& m : all) {
        EXPECT_TRUE(has(m, {"name", "aliases", "class", "kind", "page", "index", "f0", "range_nm", "citation",
                            "licence", "quality"}))
            << m["name"];
        EXPECT_FALSE(m["citation"].get<std::string>().empty()) << m["name"];
        EXPECT_EQ(m["page"].is_null(), m["kind"] != "spectral") << m["name"];
        ++kinds[m["kind"]];
    }
    EXPECT_GE(kinds["spectral"], 66);
    EXPECT_EQ(kinds["index"], 23);
    EXPECT_GE(kinds["f0"], 10);
}

TEST_F(command, show_prints_n_and_k_of_a_material_by_name_alias_or_page) {
    for (const char* name : {"copper", "Cu", "main/Cu/nk/Johnson"}) {
        const nlohmann::json one = json(std::string("materials show ") + name + " --json");
        EXPECT_EQ(one["name"], "copper");
        EXPECT_EQ(one["nk"].size(), 41u);
    }
    EXPECT_EQ(run("materials show skin").code, 0);
}

TEST_F(command, f0_has_its_keys_for_every_kind_in_every_space) {
    for (const char* name : {"gold", "n-bk7", "skin", "olive-oil", "vacuum"})
        for (const char* space : {"srgb", "p3", "rec2020", "acescg", "xyz"}) {
            const nlohmann::json one = json(std::string("f0 ") + name + " --json --space " + space);
            EXPECT_TRUE(has(one, {"material", "page", "space", "ambient", "recipe", "f0", "f82", "f82_tint",
                                  "gulbrandsen", "average", "srgb8", "hex"}))
                << name;
            EXPECT_TRUE(has(one["gulbrandsen"], {"r", "g"}));
            for (const auto& v : one["f0"])
                EXPECT_TRUE(v.is_number()) << name << " " << one["f0"];
        }
}

TEST_F(command, f0_marks_gold_outside_srgb_and_limits_it_when_asked) {
    EXPECT_FALSE(json("f0 gold --json")["in_gamut"].get<bool>());
    EXPECT_GT(json("f0 gold --json")["f0"][0].get<double>(), 1);
    EXPECT_EQ(json("f0 gold --json --gamut clamp")["f0"][0], 1);
    EXPECT_EQ(json("f0 gold --json --gamut divide")["f0"][0], 1);
    const nlohmann::json as_is = json("f0 gold --json"), divided = json("f0 gold --json --gamut divide");
    const double factor = as_is["f0"][0];
    for (const char* key : {"f0", "f82", "average"})
        EXPECT_NEAR(divided[key][1].get<double>(), as_is[key][1].get<double>() / factor, 1e-12) << key;
    EXPECT_EQ(divided["gulbrandsen"]["r"][1], divided["f0"][1]);
    EXPECT_NE(divided["hex"], as_is["hex"]);
    EXPECT_FALSE(divided["hex_clamped"].get<bool>());
    EXPECT_FALSE(divided["in_gamut"].get<bool>()) << "before it was limited";
    EXPECT_TRUE(json("f0 gold --json --space acescg")["in_gamut"].get<bool>());
    EXPECT_NE(run("f0 gold").out.find("clamped"), std::string::npos);
}

TEST_F(command, f0_reads_a_users_own_table) {
    write("mine.csv", "wavelength_nm,n,k\n400,1.5,0\n700,1.5,0\n");
    EXPECT_NEAR(json("f0 mine.csv --json")["f0"][1].get<double>(), 0.04, 1e-12);
    EXPECT_EQ(run("f0 mine.csv").out.rfind("mine.csv  (your table)\n", 0), 0u) << run("f0 mine.csv").out;
}

TEST_F(command, tables_have_no_blanks_at_the_ends_of_their_lines) {
    for (const char* line : {"compare gold", "materials", "figures rtr4-table-9-2", "models",
                             "angles --n-t 1.5", "convert metalness --base 1 0.8 0.3 --metalness 0.5",
                             "f0 gold", "cost --recorded", "identify 0.3", "materials show gold"}) {
        const auto result = run(line);
        EXPECT_EQ(result.code, 0) << line << "\n" << result.err;
        EXPECT_EQ(result.out.find(" \n"), std::string::npos) << line << "\n" << result.out;
    }
}

// ---- bad input ----------------------------------------------------------------------------------------------

TEST_F(command, an_unknown_name_is_refused_with_the_nearest) {
    expect_refused("modles", {"modles", "models"});
    expect_refused("models shlick", {"shlick", "schlick"});
    expect_refused("eval shlick", {"shlick", "schlick"});
    expect_refused("eval shlick --csv -", {"shlick", "schlick"}, "printf '' | ");
    expect_refused("f0 coper", {"coper", "copper"});
    expect_refused("compare copper golld", {"golld", "gold"});
    expect_refused("materials show coper", {"coper", "copper"});
    expect_refused("eval schlick --material coper", {"coper", "copper"});
    expect_refused("f0 copper --space sgrb", {"sgrb", "srgb"});
    expect_refused("f0 copper --gamut cut", {"cut", "clamp"});
    expect_refused("materials --class meta", {"meta", "metal"});
    expect_refused("materials --kind spectrum", {"spectrum", "spectral"});
}

TEST_F(command, nothing_or_too_much_is_refused) {
    expect_refused("", {"fresnel: "});
    expect_refused("eval", {"MODEL"});
    expect_refused("f0", {"NAME"});
    expect_refused("compare", {"NAME"});
    expect_refused("f0 copper gold", {"gold"});
    expect_refused("eval schlick --frequency 3", {"--frequency"});
    expect_refused("eval schlick --n-t 1.5", {"n_t", "schlick", "f0"});
    expect_refused("eval schlick --cos-i 0.5 --theta 60", {"--cos-i", "--theta"});
    expect_refused("eval schlick --out x.csv", {"--out", "x.csv", "--csv"});
    expect_refused("eval schlick --type half --csv -", {"half", "float"});
    expect_refused("eval conductor --wavelength 500", {"--wavelength 500", "--material"});
    expect_refused("eval schlick --csv - --wavelength 500", {"--csv", "leave"});
    expect_refused("eval schlick --csv - --json", {"--json", "--csv '-'"});
    expect_refused("eval schlick --cos-i 0:1:2.5", {"0:1:2.5", "whole"});
    expect_refused("eval dielectric --material gold", {"--material 'gold'", "k = 2.472", "conductor"});
    expect_refused("claims --json --markdown", {"--json", "--markdown"});
    expect_refused("claims wloka-schlick --sources", {"wloka-schlick", "--sources"});
    expect_refused("figures --list nosuch", {"nosuch", "--list"});
    expect_refused("figures --list --out x", {"--out 'x'", "--list"});
    expect_refused("shader schlick --fix f0=.1 --fix f0=.2", {"--fix 'f0=.2'", "already"});
    expect_refused("--verison", {"'--verison'", "did you mean '--version'"});
    expect_refused("-x", {"'-x'", "--help"});
    for (const char* law : {"disney", "unreal", "frostbite", "unity"})
        expect_refused(std::string("convert metalness --base .5 --ior 1.6 --law ") + law, {"--ior 1.6", law});
    expect_refused("convert metalness --f0 .5 --albedo 0 --ior 1.6 --law unity", {"--ior 1.6", "unity"});
    EXPECT_EQ(run("convert metalness --base .5 --ior 1.6").code, 0);
}

// It was taken for none: `eval conductor --material ''` was glass.
TEST_F(command, an_empty_value_is_refused_by_its_option) {
    for (const std::string start : {"models NAME",
                                    "eval MODEL",
                                    "eval conductor --material",
                                    "eval schlick --f0",
                                    "eval schlick --cos-i",
                                    "eval schlick --csv",
                                    "eval schlick --csv - --out",
                                    "f0 NAME",
                                    "f0 copper --space",
                                    "materials --class",
                                    "materials --kind",
                                    "materials show NAME",
                                    "compare copper --out",
                                    "angles --material",
                                    "figures wloka-1 --out",
                                    "claims ID",
                                    "convert metalness --base .5 --law",
                                    "prove schlick --material",
                                    "plot copper --fit",
                                    "plot schlick --family",
                                    "plot copper --title",
                                    "plot copper --out",
                                    "shader schlick --fix",
                                    "lut schlick --out",
                                    "lut schlick --format",
                                    "conform a.glsl --as schlick --function",
                                    "cost schlick --gpu",
                                    "cost schlick --technique"}) {
        const std::size_t last = start.rfind(' ');
        const bool option = start[last + 1] == '-';
        expect_refused(start.substr(0, option ? start.size() : last) + " ''",
                       {"fresnel: " + start.substr(last + 1) + ": must not be ''"});
    }
}

TEST_F(command, a_value_outside_its_range_is_refused_with_the_range) {
    expect_refused("eval dielectric --n-t 0 --cos-i 1", {"n_t = 0", "[0.001, 1000]"});
    expect_refused("eval dielectric --n-t -1.5 --cos-i 1", {"n_t = -1.5", "[0.001, 1000]"});
    expect_refused("eval schlick_internal --eta 0 --cos-i 1", {"eta = 0", "[0.01, 1]"});
    expect_refused("eval schlick --cos-i 2", {"cos_i = 2", "[0, 1]"});
    expect_refused("eval schlick --cos-i -0.1", {"cos_i = -0.1", "[0, 1]"});
    expect_refused("eval schlick --theta 91", {"theta = 91", "[0, 90]"});
    expect_refused("eval schlick --f0 nan", {"f0 = nan", "[0, 1]"});
    expect_refused("eval schlick --f0 inf", {"f0 = inf", "[0, 1]"});
    expect_refused("eval schlick --f0 1.5", {"f0 = 1.5", "[0, 1]"});
    expect_refused("eval schlick --f0 shiny", {"f0 = 'shiny'", "number"});
    expect_refused("eval schlick --theta 0:90:1", {"0:90:1", "COUNT"});
    expect_refused("eval schlick --theta 0:90", {"0:90", "COUNT"});
    expect_refused("eval schlick --material copper --wavelength 0", {"wavelength = 0"});
    expect_refused("eval dielectric --n-t 1e999", {"n_t = inf", "[0.001, 1000]"});
    expect_refused("eval dielectric --n-t 1e-400", {"n_t = 0", "[0.001, 1000]"});
    EXPECT_EQ(run("eval conductor --k-t 1e-400 --cos-i 1").code, 0);
    expect_refused("f0 copper --ambient 0", {"ambient = 0", "[0.01, 100]"});
    expect_refused("f0 copper --ambient nan", {"ambient = nan", "[0.01, 100]"});
    expect_refused("compare copper --ambient air", {"ambient = 'air'", "number"});
}

TEST_F(command, whatever_a_value_holds_the_error_is_one_line) {
    expect_refused("f0 \"$(printf 'cop\\nper\\033[1m')\"", {"cop\\nper\\x1b[1m"});
    expect_refused("eval schlick --f0 \"$(printf 'a\\tb')\"", {"a\\tb", "number"});
}

TEST_F(command, output_that_does_not_arrive_is_a_failure) {
    for (const char* arguments : {"--help", "eval --help", "--version", "models", "f0 gold --json"})
        EXPECT_EQ(run(std::string(arguments) + " >/dev/full").code, 1) << arguments;
}

TEST_F(command, a_message_that_does_not_arrive_changes_nothing) {
    for (const char* nowhere : {" 2>&-", " 2>/dev/full"}) {
        EXPECT_EQ(run(std::string("f0 nosuch") + nowhere).code, 2);
        EXPECT_EQ(run(std::string("lut gold --out q.png") + nowhere).code, 0);
    }
    EXPECT_EQ(run("models >&- 2>&-").code, 1);
}

// A file that is opened would otherwise be given the number of a stream that is closed.
TEST_F(command, what_is_printed_does_not_go_into_a_file) {
    EXPECT_EQ(run("lut gold --out expected.exr").code, 0);
    EXPECT_EQ(run("lut gold --out closed_1.exr 2>&-").code, 0);
    EXPECT_EQ(run("lut gold --out closed_2.exr <&- >&- 2>&-").code, 1);
    const auto size = [&](const char* name) { return std::filesystem::file_size(folder / "work" / name); };
    EXPECT_EQ(size("closed_1.exr"), size("expected.exr"));
    EXPECT_EQ(size("closed_2.exr"), size("expected.exr"));
    EXPECT_EQ(run("eval schlick --csv - <&-").code, 1);
}

TEST_F(command, a_folder_for_scratch_files_that_is_none_is_named) {
    const auto result = run("plot copper --out a.png", "TMPDIR=/nonexist ");
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err, "fresnel: TMPDIR '/nonexist': is no folder for scratch files\n");
    EXPECT_TRUE(files().empty());
}

TEST_F(command, a_table_beyond_every_index_is_refused_by_line_and_column) {
    write("n.csv", "wavelength_nm,n,k\n500,1.5,0\n600,1e60,0\n");
    write("k.csv", "wavelength_nm,n,k\n500,1.5,1e60\n");
    write("n.yml", "DATA:\n  - type: tabulated nk\n    data: |\n      0.5 1e60 0\n");
    write("formula.yml",
          "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 0.9\n    coefficients: 1e60\n");
    write("high.csv", "wavelength_nm,n,k\n500,2000,0\n");
    for (const char* with : {"f0 ", "compare ", "angles --material ", "eval conductor --material "}) {
        expect_refused(std::string(with) + "n.csv", {"n.csv:3:5: n is 1e60", "[0, 10000]"});
        expect_refused(std::string(with) + "k.csv", {"k.csv:2:9: k is 1e60", "[0, 10000]"});
        expect_refused(std::string(with) + "n.yml", {"n.yml:4: n is 1e60", "10000]"});
        expect_refused(std::string(with) + "formula.yml", {"n = 1e+60", "10000]"});
    }
    expect_refused("angles --material high.csv", {"n_t = 2000", "[0.001, 1000]"});
}

// They gave an average of -1e17, and NaN.
TEST_F(command, an_index_of_nothing_is_refused_wherever_it_comes_from) {
    const std::string page = "DATA:\n  - type: ";
    write("negative.yml", page + "tabulated n\n    data: |\n      0.4 -1.5\n      0.7 -1.5\n");
    write("zero.yml", page + "tabulated nk\n    data: |\n      0.4 0 0\n      0.7 0 0\n");
    write("formula.yml", page + "formula 5\n    wavelength_range: 0.3 0.9\n    coefficients: -0.5\n");
    write("metal.yml", page + "tabulated nk\n    data: |\n      0.4 0 2\n      0.7 0 3\n");
    for (const char* with : {"f0 ", "compare ", "angles --material ", "eval conductor --material "}) {
        expect_refused(std::string(with) + "negative.yml", {"'negative': n = -1.5 at", "in [0, 10000]"});
        expect_refused(std::string(with) + "zero.yml", {"'zero': n and k are both 0 at", "above 0"});
        expect_refused(std::string(with) + "formula.yml", {"'formula': n = -0.5 at", "in [0, 10000]"});
    }
    EXPECT_EQ(run("f0 metal.yml").code, 0);
}

TEST_F(command, a_table_that_is_no_utf_8_is_named) {
    write("wide.csv", std::string("\xff\xfe"
                                  "f\0"
                                  "0\0",
                                  6));
    expect_refused("f0 wide.csv", {"wide.csv:1:1: is UTF-16; save it as UTF-8"});
    expect_refused("eval schlick --csv wide.csv", {"line 1, column 1: is UTF-16; save it as UTF-8"});
    write("zero.csv", std::string("f\0"
                                  "0,cos_i\n",
                                  9));
    expect_refused("f0 zero.csv", {"column 'f\\x000' is unknown; the header is"});
    expect_refused("eval schlick --csv zero.csv", {"'f\\x000' is no argument", "it takes"});
}

TEST_F(command, a_file_s_name_need_not_be_utf_8) {
    write("\xff.csv", "wavelength_nm,n,k\n500,0.5,3\n600,0.4,3\n");
    for (const char* arguments : {"f0 \xff.csv --json", "compare \xff.csv --json", "f0 \xff.csv"})
        EXPECT_EQ(run(arguments).code, 0) << run(arguments).err;
}

TEST_F(command, a_file_that_cannot_be_read_is_refused) {
    write("noise.csv", std::string("\x7f"
                                   "ELF\0\xff\xfe\0\0\n\0",
                                   11));
    write("noise.yml", std::string("\x7f"
                                   "ELF\0\xff\xfe\0\0\n\0",
                                   11));
    write("empty.csv", "");
    write("empty.yml", "");
    write("nothing.csv", "wavelength_nm,n,k\n500,0.5,3\n600,0,0\n");
    expect_refused("f0 nothing.csv", {"nothing.csv:3", "n and k"});
    write("pole.yml",
          "DATA:\n  - type: formula 1\n    wavelength_range: 0.3 0.9\n    coefficients: 0 -3 0.55\n");
    for (const char* with : {"f0 pole.yml", "compare pole.yml", "angles --material pole.yml",
                             "eval schlick --material pole.yml"})
        expect_refused(with, {"'pole'", "550 nm"});
    expect_refused("eval schlick --csv missing.csv", {"missing.csv"});
    expect_refused("eval schlick --csv .", {"'.'", "directory"});
    const auto folder_as_input = run("eval schlick --csv - < .");
    EXPECT_EQ(folder_as_input.code, 1);
    EXPECT_NE(folder_as_input.err.find("cannot be read"), std::string::npos) << folder_as_input.err;
    expect_refused("eval schlick --csv noise.csv", {"line 1"});
    expect_refused("eval schlick --csv empty.csv", {"header"});
    for (const char* command_name : {"f0", "compare", "materials show"})
        for (const char* file :
             {"missing.csv", "missing.yml", "noise.csv", "noise.yml", "empty.csv", "empty.yml"})
            expect_refused(std::string(command_name) + " " + file, {file});
    std::filesystem::create_directory(folder / "work" / "folder.yml");
    expect_refused("f0 folder.yml", {"folder.yml"});
}

TEST_F(command, a_bad_csv_row_is_refused_by_line_and_column_and_leaves_no_file) {
    const auto refuse = [&](const std::string& text, const std::vector<std::string>& pieces) {
        write("rows.csv", text);
        expect_refused("eval conductor --csv rows.csv --out results.csv", pieces);
        expect_refused("eval conductor --csv rows.csv --type 50 --out results.csv", pieces);
    };
    refuse("n_t,k_t,cos_i\n1.5,0,1\n1.5,0\n",
           {"line 3, column 3 (cos_i): is missing", "the header has 3 columns"});
    refuse("n_t,k_t,cos_i\n1.5,0,1,7,8\n", {"line 2, column 4: '7' is too much", "the header has 3 columns"});
    refuse("n_t,k_t,cos_i\n1.5,0,1\n\n", {"line 3: is blank; leave it out"});
    refuse("n_t,k_t,cos_i\n1.5,0,1.5\n", {"line 2, column 3 (cos_i)", "1.5", "[0, 1]"});
    refuse("n_t,k_t,cos_i\n0,0,1\n", {"line 2, column 1 (n_t)", "[0.001, 1000]"});
    refuse("n_t,k_t,cos_i\n1.5,-1,1\n", {"line 2, column 2 (k_t)", "-1"});
    refuse("n_t,k_t,cos_i\n1.5,nan,1\n", {"line 2, column 2 (k_t)", "nan"});
    refuse("n_t,k_t,cos_i\n1.5,0,one\n", {"line 2, column 3 (cos_i)", "one", "number"});
    refuse("n_t,k_t,cos_i\n1.5,,1\n", {"line 2, column 2 (k_t)", "number"});
    refuse("n_t,kt,cos_i\n", {"line 1, column 2", "kt", "k_t"});
    refuse("n_t,n_t,cos_i\n", {"line 1, column 2", "n_t", "twice"});
    refuse("n_t,k_t\n", {"line 1", "cos_i", "missing"});
    refuse("k_t,cos_i\n", {"line 1", "n_t", "missing"});
}

TEST_F(command, an_unwritable_place_is_refused) {
    write("rows.csv", "f0,cos_i\n0.04,1\n");
    write("file", "");
    expect_refused("eval schlick --csv rows.csv --out nowhere/results.csv", {"nowhere/results.csv"});
    expect_refused("eval schlick --csv rows.csv --out .", {"'.'"});
    expect_refused("shader schlick --out file/x", {"--out 'file/x'"});
    expect_refused("compare copper --out file", {"--out", "file"});
    expect_refused("compare copper --out file/below", {"--out", "file/below"});
    expect_refused("compare copper --out /proc/fresnel", {"--out", "/proc/fresnel"});
}

} // namespace
