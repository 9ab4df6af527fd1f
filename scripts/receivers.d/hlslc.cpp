// hlslc fxc|dxc DLL LIST
// Compiles HLSL with Microsoft's compilers, which are Windows libraries: built by mingw, run in wine. Each line of LIST is
// PROFILE ENTRY FILE [LISTING]. For each it prints `== OK SLOTS` or `== FAILED`, then what the compiler said, and fxc
// writes the listing. Warnings are failures.
#include <windows.h>

#include <d3dcompiler.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct job {
    std::string profile, entry, file, listing;
};

struct outcome {
    bool accepted = false;
    int slots = 0;
    std::string said;
};

std::string contents(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// ---- FXC: d3dcompiler_47.dll -------------------------------------------------------------------------------------------

struct fxc {
    explicit fxc(HMODULE library)
        : compile(reinterpret_cast<pD3DCompile>(GetProcAddress(library, "D3DCompile"))),
          disassemble(reinterpret_cast<pD3DDisassemble>(GetProcAddress(library, "D3DDisassemble"))) {}

    outcome operator()(const job& j) const {
        const std::string source = contents(j.file);
        ID3DBlob *code = nullptr, *messages = nullptr, *listing = nullptr;
        const HRESULT result =
            compile(source.data(), source.size(), j.file.c_str(), nullptr, nullptr, j.entry.c_str(),
                    j.profile.c_str(), D3DCOMPILE_OPTIMIZATION_LEVEL3 | D3DCOMPILE_ENABLE_STRICTNESS, 0,
                    &code, &messages);
        outcome o;
        if (messages) o.said.assign(static_cast<const char*>(messages->GetBufferPointer()));
        o.accepted = SUCCEEDED(result) && o.said.empty();
        if (SUCCEEDED(result) &&
            SUCCEEDED(disassemble(code->GetBufferPointer(), code->GetBufferSize(), 0, nullptr, &listing))) {
            const char* text = static_cast<const char*>(listing->GetBufferPointer());
            if (const char* count = std::strstr(text, "approximately "))
                o.slots = std::atoi(count + std::strlen("approximately "));
            if (!j.listing.empty()) std::ofstream(j.listing) << text;
        }
        for (ID3DBlob* blob : {code, messages, listing})
            if (blob) blob->Release();
        return o;
    }

    pD3DCompile compile;
    pD3DDisassemble disassemble;
};

// ---- DXC: dxcompiler.dll, as far as its interfaces are needed ----------------------------------------------------------

struct dxc_blob : IUnknown {
    virtual void* STDMETHODCALLTYPE pointer() = 0;
    virtual SIZE_T STDMETHODCALLTYPE size() = 0;
};
struct dxc_result : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE status(HRESULT*) = 0;
    virtual HRESULT STDMETHODCALLTYPE result(dxc_blob**) = 0;
    virtual HRESULT STDMETHODCALLTYPE errors(dxc_blob**) = 0;
};
struct dxc_source {
    const void* text;
    SIZE_T size;
    UINT encoding;
};
struct dxc_compiler : IUnknown {
    virtual HRESULT STDMETHODCALLTYPE compile(const dxc_source*, const wchar_t**, UINT32, void*, REFIID,
                                              void**) = 0;
};

constexpr GUID compiler_class = {
    0x73e22d93, 0xe6ce, 0x47f3, {0xb5, 0xbf, 0xf0, 0x66, 0x4f, 0x39, 0xc1, 0xb0}};
constexpr GUID compiler_interface = {
    0x228b4687, 0x5a6a, 0x4730, {0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54}};
constexpr GUID result_interface = {
    0x58346cda, 0xdde7, 0x4497, {0x94, 0x61, 0x6f, 0x87, 0xaf, 0x5e, 0x06, 0x59}};

struct dxc {
    explicit dxc(HMODULE library) {
        using create = HRESULT(WINAPI*)(REFCLSID, REFIID, void**);
        const auto make = reinterpret_cast<create>(GetProcAddress(library, "DxcCreateInstance"));
        if (make) make(compiler_class, compiler_interface, reinterpret_cast<void**>(&compiler));
    }

    outcome operator()(const job& j) const {
        outcome o;
        if (!compiler) return o.said = "the library makes no compiler", o;
        const std::string source = contents(j.file);
        const dxc_source given = {source.data(), source.size(), 65001}; // UTF-8
        std::vector<std::wstring> words = {wide(j.file), L"-T", wide(j.profile), L"-O3", L"-WX"};
        if (j.profile.compare(0, 3, "lib") != 0) words.insert(words.end(), {L"-E", wide(j.entry)});
        std::vector<const wchar_t*> arguments;
        for (const std::wstring& word : words)
            arguments.push_back(word.c_str());
        dxc_result* made = nullptr;
        const HRESULT result =
            compiler->compile(&given, arguments.data(), static_cast<UINT32>(arguments.size()), nullptr,
                              result_interface, reinterpret_cast<void**>(&made));
        if (FAILED(result) || !made) return o.said = "the compiler did not run", o;
        HRESULT status = E_FAIL;
        made->status(&status);
        dxc_blob* messages = nullptr;
        if (SUCCEEDED(made->errors(&messages)) && messages)
            o.said.assign(static_cast<const char*>(messages->pointer()), messages->size());
        while (!o.said.empty() && (o.said.back() == '\0' || o.said.back() == '\n'))
            o.said.pop_back();
        o.accepted = SUCCEEDED(status) && o.said.empty();
        made->Release();
        return o;
    }

    static std::wstring wide(const std::string& text) { return {text.begin(), text.end()}; }
    dxc_compiler* compiler = nullptr;
};

std::vector<job> jobs(const char* list) {
    std::ifstream in(list);
    std::vector<job> all;
    std::string line;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        job j;
        if (fields >> j.profile >> j.entry >> j.file) {
            fields >> j.listing;
            all.push_back(j);
        }
    }
    return all;
}

template <class Compiler>
void run(const Compiler& compiler, const std::vector<job>& all) {
    for (const job& j : all) {
        const outcome o = compiler(j);
        if (o.accepted)
            std::printf("== OK %d\n", o.slots);
        else
            std::printf("== FAILED\n%s\n", o.said.c_str());
    }
}

} // namespace

int main(int count, char** arguments) {
    if (count != 4) return std::fputs("usage: hlslc fxc|dxc DLL LIST\n", stderr), 2;
    const HMODULE library = LoadLibraryA(arguments[2]);
    if (!library) return std::fprintf(stderr, "hlslc: '%s': cannot be loaded\n", arguments[2]), 1;
    if (std::strcmp(arguments[1], "fxc") == 0)
        run(fxc(library), jobs(arguments[3]));
    else
        run(dxc(library), jobs(arguments[3]));
}
