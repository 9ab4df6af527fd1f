#include "csv.hpp"

#include "commands.hpp"

#include "analysis/model_table.hpp"
#include "analysis/multi.hpp"
#include "error.hpp"
#include "figure/leftover.hpp"
#include "files.hpp"
#include "materials/table.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <unistd.h>

namespace fresnel::cli {

namespace {

// ---- numbers ----------------------------------------------------------------------------------------------

using cli::read_number; // of float and double

bool read_number(std::string_view text, real50& value) {
    double check = 0;
    if (!read_number(text, check)) return false;
    value = real50(std::string(text));
    return true;
}

// A limit as it is written, of which the double is but the nearest: 0.001 at 50 digits is inside [0.001, 1000].
template <class T>
T as_written(double limit) {
    if constexpr (std::is_same_v<T, real50>)
        return real50(fmt::format("{}", limit));
    else
        return T(limit);
}

template <class T>
void append(std::string& line, T value) {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    line.append(digits.data(), end);
}

void append(std::string& line, const real50& value) { line += value.str(50); }

// ---- reading ----------------------------------------------------------------------------------------------

std::string_view trimmed(std::string_view cell) {
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t'))
        cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t'))
        cell.remove_suffix(1);
    return cell;
}

void split(std::string_view line, std::vector<std::string_view>& cells) {
    cells.clear();
    for (std::size_t begin = 0;;) {
        const std::size_t comma = line.find(',', begin);
        cells.push_back(trimmed(line.substr(begin, comma - begin)));
        if (comma == std::string_view::npos) return;
        begin = comma + 1;
    }
}

class line_reader {
public:
    explicit line_reader(const std::string& path) : path_(path), file_(open(path)) {}
    ~line_reader() { std::free(buffer_); }
    line_reader(const line_reader&) = delete;
    line_reader& operator=(const line_reader&) = delete;

    // The next line without its end, or false at the end of the file.
    bool next(std::string_view& line) {
        const ssize_t size = getline(&buffer_, &capacity_, file_.get());
        if (size < 0 && std::ferror(file_.get()) != 0)
            throw failure(fmt::format("--csv '{}': cannot be read: {}", path_, std::strerror(errno)));
        if (size < 0) return false;
        ++number_;
        line = {buffer_, static_cast<std::size_t>(size)};
        if (line.ends_with('\n')) line.remove_suffix(1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (number_ == 1 && begins_utf_16(line))
            throw bad_input("line 1, column 1: is UTF-16; save it as UTF-8");
        if (number_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
        return true;
    }
    std::size_t number() const { return number_; }

private:
    static file_handle open(const std::string& path) {
        if (path == "-") return {stdin, [](std::FILE*) { return 0; }};
        if (is_folder(path)) throw bad_input(fmt::format("--csv '{}': is a directory, not a file", path));
        file_handle file(std::fopen(path.c_str(), "rb"), std::fclose);
        if (!file) throw bad_input(fmt::format("--csv '{}': cannot be opened", path));
        return file;
    }

    std::string path_;
    file_handle file_;
    char* buffer_ = nullptr;
    std::size_t capacity_ = 0;
    std::size_t number_ = 0;
};

// ---- writing ----------------------------------------------------------------------------------------------

// Standard output, or a file that takes its place when everything is written.
class row_writer {
public:
    explicit row_writer(const std::string& path) : name_(path == "-" ? "" : path) {
        if (is_folder(name_)) throw bad_input(fmt::format("--out '{}': is a folder; give a file", name_));
        if (!name_.empty()) staged_.emplace(name_);
        file_ = staged_ ? staged_->open() : file_handle(stdout, [](std::FILE*) { return 0; });
        if (!file_)
            throw bad_input(
                fmt::format("--out '{}': cannot be written; give a file in a folder that can", name_));
    }

    void write(std::string_view line) {
        if (std::fwrite(line.data(), 1, line.size(), file_.get()) != line.size()) fail();
        if (++lines_ % 65536 == 0) show_progress();
    }
    void finish() {
        if (shows_progress()) say("\r\033[K");
        if (std::fflush(file_.get()) != 0) fail();
        if (staged_ && (std::fclose(file_.release()) != 0 || !staged_->finish())) fail();
    }

private:
    [[noreturn]] void fail() const {
        throw failure(fmt::format("{}: cannot be written", name_.empty() ? "standard output" : name_));
    }
    // One line on a terminal that is overwritten; nothing where the rows themselves are seen.
    bool shows_progress() const { return staged_ && staged_->is_beside() && isatty(STDERR_FILENO) != 0; }
    void show_progress() const {
        if (shows_progress()) say("\r\033[Keval: {} rows", lines_);
    }

    std::string name_;
    std::optional<staged_file> staged_;
    file_handle file_{nullptr, std::fclose};
    std::size_t lines_ = 0;
};

// ---- the stream -------------------------------------------------------------------------------------------

// Where each of the model's parameters, and cos_i after them, stands in a row; absent ones keep their
// default.
struct layout {
    std::vector<parameter> wanted;
    std::vector<int> wanted_of_column;
    std::vector<bool> present;
};

// The limits of the wanted parameters, in the type of the rows.
template <class T>
struct limits {
    std::vector<T> least, most;

    explicit limits(const std::vector<parameter>& wanted) {
        for (const parameter& p : wanted)
            least.push_back(as_written<T>(p.min)), most.push_back(as_written<T>(p.max));
    }
    bool hold(const T& value, std::size_t index) const {
        return value >= least[index] && value <= most[index];
    }
};

template <class T>
layout read_header(std::string_view line, const model_row<T>& model) {
    layout header{{model.parameters.begin(), model.parameters.end()}, {}, {}};
    header.wanted.push_back(cosine);
    header.present.resize(header.wanted.size());
    std::vector<std::string> names;
    for (const parameter& p : header.wanted)
        names.emplace_back(p.name);

    std::vector<std::string_view> cells;
    split(line, cells);
    for (std::size_t column = 0; column < cells.size(); ++column) {
        const auto found = std::find(names.begin(), names.end(), cells[column]);
        const std::string place = fmt::format("line 1, column {}", column + 1);
        if (found == names.end())
            throw bad_input(fmt::format("{}: '{}' is no argument of {}{}; it takes {}", place, cells[column],
                                        model.name, did_you_mean(cells[column], names),
                                        fmt::join(names, ", ")));
        const auto index = static_cast<std::size_t>(found - names.begin());
        if (header.present[index]) throw bad_input(fmt::format("{}: '{}' stands there twice", place, *found));
        header.present[index] = true;
        header.wanted_of_column.push_back(static_cast<int>(index));
    }
    for (std::size_t i = 0; i < names.size(); ++i)
        if (!header.present[i] && !header.wanted[i].neutral)
            throw bad_input(fmt::format("line 1: column {} of {} is missing", names[i], model.name));
    return header;
}

void check_count(const std::vector<std::string_view>& cells, const layout& header, std::size_t line) {
    const std::size_t count = header.wanted_of_column.size();
    if (cells.size() == 1 && cells[0].empty())
        throw bad_input(fmt::format("line {}: is blank; leave it out", line));
    if (cells.size() < count) {
        const auto missing = static_cast<std::size_t>(header.wanted_of_column[cells.size()]);
        throw bad_input(fmt::format("line {}, column {} ({}): is missing; the header has {} columns", line,
                                    cells.size() + 1, header.wanted[missing].name, count));
    }
    if (cells.size() > count)
        throw bad_input(fmt::format("line {}, column {}: '{}' is too much; the header has {} column{}", line,
                                    count + 1, cells[count], count, count == 1 ? "" : "s"));
}

template <class T>
void read_row(const std::vector<std::string_view>& cells, const layout& header, const limits<T>& allowed,
              std::size_t line, std::vector<T>& values) {
    check_count(cells, header, line);
    for (std::size_t column = 0; column < cells.size(); ++column) {
        const auto index = static_cast<std::size_t>(header.wanted_of_column[column]);
        const parameter& p = header.wanted[index];
        const auto place = [&] { return fmt::format("line {}, column {} ({})", line, column + 1, p.name); };
        if (!read_number(cells[column], values[index]))
            throw bad_input(fmt::format("{}: '{}' is not a number", place(), cells[column]));
        if (values[index] == 0) values[index] = 0; // -0 is 0
        if (!allowed.hold(values[index], index))
            throw bad_input(fmt::format("{}: {} is not in [{}, {}]", place(), cells[column], p.min, p.max));
    }
}

template <class T>
void append_results(std::string& line, const boundary<T>& result, bool polarised) {
    const auto add = [&line](const T& value) { line += ',', append(line, value); };
    if (!polarised) return add(result.R_s);
    add(result.R_s), add(result.R_p), add(result.reflectance());
    add(result.T_s), add(result.T_p), add(result.transmittance());
}

template <class T>
void evaluate_rows(const model_row<T>& model, line_reader& input, row_writer& output) {
    std::string_view line;
    if (!input.next(line)) throw bad_input("line 1: the header is missing: the input is empty");
    const layout header = read_header(line, model);
    std::string out;
    const auto emit = [&out, &output] { output.write(out += '\n'); };
    out.assign(line) += model.polarised() ? ",Rs,Rp,R,Ts,Tp,T" : ",R";
    emit();

    std::vector<T> values;
    for (const parameter& p : header.wanted)
        values.emplace_back(as_written<T>(p.default_value));
    const limits<T> allowed(header.wanted);
    std::vector<std::string_view> cells;
    while (input.next(line)) {
        split(line, cells);
        read_row(cells, header, allowed, input.number(), values);
        out.assign(line);
        append_results(out, model.evaluate(values.data(), values.back()), model.polarised());
        emit();
    }
}

} // namespace

void evaluate_csv(const std::string& model, const std::string& input, const std::string& output,
                  const std::string& type) {
    find_model<double>(model);
    line_reader reader(input);
    row_writer writer(output);
    if (type == "float")
        evaluate_rows(find_model<float>(model), reader, writer);
    else if (type == "double")
        evaluate_rows(find_model<double>(model), reader, writer);
    else
        evaluate_rows(find_model<real50>(model), reader, writer);
    writer.finish();
}

} // namespace fresnel::cli
