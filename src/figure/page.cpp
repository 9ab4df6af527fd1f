#include "figure/page.hpp"

#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/leftover.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace fresnel {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --text: #1b1f24; --soft: #59636e; --line: #d5dae0; --ground: #ffffff; --card: #f6f8fa; --mark: #0b6e4f; }
@media (prefers-color-scheme: dark) { :root { --text: #e3e6ea; --soft: #9aa4af; --line: #363d46; --ground: #14171b; --card: #1d2127; --mark: #5fd3a5; } }
body { margin: 0 auto; max-width: 62rem; padding: 2rem 1.25rem 4rem; background: var(--ground); color: var(--text); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .4rem; } h2 { font-size: 1.4rem; margin: 3rem 0 .3rem; } p { margin: .5rem 0; }
.soft, caption { color: var(--soft); font-size: .9rem; } a { color: inherit; }
.verdict { font-size: 1.1rem; border-left: 4px solid var(--mark); padding-left: .8rem; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; width: 100%; }
th, td { text-align: right; padding: .28rem .6rem; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { color: var(--soft); font-weight: 600; } .left { text-align: left; } .wrap { white-space: normal; min-width: 22rem; text-align: left; }
tr.chosen td { background: var(--card); font-weight: 600; } tr.chosen td:nth-child(2) { color: var(--mark); }
.swatch { display: inline-block; width: 8.5rem; height: 1.5rem; border-radius: 3px; vertical-align: middle; }
figure { margin: 1.2rem 0; } figcaption { color: var(--soft); font-size: .9rem; } svg.fresnel-figure { color: var(--text); width: 100%; height: auto; } svg image { image-rendering: pixelated; }
blockquote { margin: .5rem 0; padding-left: .8rem; border-left: 3px solid var(--line); color: var(--soft); }
nav ol { columns: 2; font-size: .92rem; } .bad { color: #c0392b; font-weight: 600; } .label { font-weight: 600; }
)";

} // namespace

std::string html_page(const std::string& title, const std::string& body) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">\n<title>" +
           markup_text(title) + "</title>\n<style>" + style + "</style></head><body>\n" + body +
           "</body></html>\n";
}

void require_writable_folder(const std::string& argument, const std::string& dir) {
    std::error_code error;
    make_folders(dir, error);
    if (error || !is_folder(dir) || access(dir.c_str(), W_OK | X_OK) != 0)
        throw bad_input(fmt::format("{} '{}': must be a folder that can be written into{}", argument, dir,
                                    error ? " (" + error.message() + ")" : ""));
}

} // namespace fresnel
