# Writes OUTPUT, a C++ source with the text of each of FILES (names relative to FOLDER) as a string literal, and the
# functions LOOKUP and NAMES, which HEADER declares.
set(text "#include \"${HEADER}\"\n\nnamespace fresnel {\nnamespace {\n\nusing namespace std::string_view_literals;\n
struct file {\n    std::string_view path, text;\n};\n\nconstexpr file files[] = {\n")
foreach(name IN LISTS FILES)
    file(READ ${FOLDER}/${name} content)
    string(APPEND text "{\"${name}\"sv, R\"~data~(${content})~data~\"sv},\n")
endforeach()
string(APPEND text "};\n\n} // namespace\n
std::string_view ${LOOKUP}(std::string_view path) {
    for (const file& f : files)
        if (f.path == path) return f.text;
    return {};
}\n
std::vector<std::string_view> ${NAMES}(std::string_view prefix) {
    std::vector<std::string_view> names;
    for (const file& f : files)
        if (f.path.starts_with(prefix)) names.push_back(f.path);
    return names;
}\n\n} // namespace fresnel\n")
file(WRITE ${OUTPUT} "${text}")
